/* string - the four functions that a freestanding compiler takes to be there
 *
 * For compilers that come without a C library, whose header this is then instead
 * (-isystem platform/headers in board.mk); platform/bare/memory.c has the functions.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_HEADERS_STRING_H
#define PLT_HEADERS_STRING_H

#include <stddef.h>

void *memcpy(void *restrict to, const void *restrict from, size_t count);
void *memmove(void *to, const void *from, size_t count);
void *memset(void *to, int value, size_t count);
int memcmp(const void *a, const void *b, size_t count);

#endif
