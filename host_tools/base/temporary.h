/* temporary - what must not outlive the program: files beside their target, sockets, colours, modes
 *
 * A normal exit, and every signal that ends the program and can be caught, remove every
 * temporary file that was neither kept nor removed. A forked child
 * removes none of its parent's. The signals also reset the colours of a
 * terminal, if it accepts bytes at all: Ctrl-C discards what was written and not
 * yet shown, which may be the reset at the end of a line.
 *
 * SPDX-License-Identifier: MIT */
#ifndef TEMPORARY_H
#define TEMPORARY_H
#include <sys/types.h>
#include <termios.h>

/* Caller's memory; at one address from creation to keep or remove. */
typedef struct temporary {
    struct temporary *volatile next;
    char *path; /* owned; NULL: there is no file */
    pid_t owner;
} temporary;

/* Creates a file in the directory of `target`, with the mode a new file
 * gets here. Returns its descriptor, or -1 with errno set. */
int temporary_create(temporary *t, const char *target);

/* The file that `make` makes at `path` (0: it did, else errno says why not): the end of the
 * program removes it, and temporary_remove. Returns what `make` does. */
int temporary_make(temporary *t, const char *path, int (*make)(void *context), void *context);

/* Renames the file over `target`. Returns 0, or the errno after which the
 * file is removed. Both calls allow a temporary without a file. */
int temporary_keep(temporary *t, const char *target);
void temporary_remove(temporary *t);

/* From now on the terminal of these two files has other modes than `modes`, and another screen,
 * that `text`, in static storage, puts back: temporary_terminal_restore does both, drops what was
 * typed, and so does the end of the program, by a signal or not. */
void temporary_terminal(int in, int out, const struct termios *modes, const char *text);
void temporary_terminal_restore(void);

/* From now on `file` is a terminal with colours. */
void temporary_colours(int file);

#endif
