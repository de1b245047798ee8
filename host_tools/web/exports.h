/* exports - what the page may call: WEB_EXPORT(type, name) before a function's parameters
 *
 * SPDX-License-Identifier: MIT */
#ifndef WEB_EXPORTS_H
#define WEB_EXPORTS_H

#define WEB_EXPORT(type, name) __attribute__((export_name(#name))) type name

#endif
