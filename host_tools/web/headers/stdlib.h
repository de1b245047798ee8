/* stdlib - what the page's program has of C's stdlib.h: heap.c
 *
 * Files are shared with the programs of the host. What is declared here and not there is of
 * functions that the page does not call, and the linker leaves out.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WEB_STDLIB_H
#define PLT_WEB_STDLIB_H

#include <stddef.h>

void *malloc(size_t bytes);
void *calloc(size_t count, size_t bytes);
void *realloc(void *from, size_t bytes);
void free(void *from);

unsigned long strtoul(const char *text, char **end, int base);

#endif
