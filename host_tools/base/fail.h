/* fail - one sentence that says what went wrong, where, and what to do
 *
 * Every fallible host function takes a `fail *` last, and returns 0 or
 * -1 (NULL for pointers). The first failure wins: `fail_set` keeps a text
 * that is already there, and clean-up code cannot hide the cause.
 *
 * The sentence has the form "FILE: LOCATION: WHAT; REMEDY", on one line.
 *
 * SPDX-License-Identifier: MIT */
#ifndef FAIL_H
#define FAIL_H

typedef struct fail {
    char text[640]; /* empty: no failure yet; never holds a line break */
} fail;

/* Sets "file: " and the formatted rest. `file` may be NULL. Control
 * characters (a hostile file name or token) become '?'. Returns -1. */
int fail_set(fail *f, const char *file, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
