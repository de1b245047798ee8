/* string - platform/headers/string.h, and functions that the page's program does not call
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WEB_STRING_H
#define PLT_WEB_STRING_H

#include "platform/headers/string.h"

size_t strlen(const char *text);
int strcmp(const char *a, const char *b);
char *strchr(const char *text, int c);
size_t strspn(const char *text, const char *accepted);

#endif
