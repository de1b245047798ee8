/* quote - file names and values as words for the shell, for commands that are copied
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

/* The same of what follows a flag or is no file: "-" or a negative number. */
const char *quote_value(char *to, size_t room, const char *value);

/* Room that is enough for any text of so many bytes: four for each, $'./' and a zero. */
static inline size_t quote_room_for(size_t bytes) {
    return 4 * bytes + 6;
}

#endif
