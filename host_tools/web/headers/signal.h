/* signal - a page gets none; the displays' drivers name the type
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WEB_SIGNAL_H
#define PLT_WEB_SIGNAL_H

typedef int sig_atomic_t;

#endif
