/* stdio - a page has no files; headers of programs name the type
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WEB_STDIO_H
#define PLT_WEB_STDIO_H

typedef struct FILE FILE;

#endif
