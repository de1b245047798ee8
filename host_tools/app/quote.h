/* quote - a file name as a word for the shell, for hints that are copied from the terminal
 *
 * SPDX-License-Identifier: MIT */
#ifndef QUOTE_H
#define QUOTE_H
#include <stddef.h>

/* Room for a word that a hint shows; a longer name gets no hint. */
enum { QUOTE_ROOM = 200 };

/* Writes `name` so that sh reads it back as one word that is no flag: as it is, in single
 * quotes, or, with control characters, in $'...' (POSIX.1-2024). Returns `to`, or NULL when it
 * does not fit. */
const char *quote_word(char *to, size_t room, const char *name);

#endif
