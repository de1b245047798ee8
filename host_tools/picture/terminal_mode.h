/* terminal_mode - a terminal that a program draws in and reads keys from
 *
 * Keys come as they are pressed and are not shown; the screen is the alternate one, without a
 * cursor, and the mouse is reported. All of it is put back by terminal_mode_leave, and by every end
 * of the program that can be caught.
 *
 * SPDX-License-Identifier: MIT */
#ifndef TERMINAL_MODE_H
#define TERMINAL_MODE_H

/* -1, with errno set, and nothing has changed: `in` or `out` is no terminal. `in` and `out` are
 * files of one terminal. One terminal at a time. */
int terminal_mode_enter(int in, int out);

/* After terminal_mode_enter: all of it once more, as others may have changed it while the program
 * was stopped; what is put back is what it was at first. */
int terminal_mode_again(void);

/* What was typed and not read is dropped. Without terminal_mode_enter: nothing. */
void terminal_mode_leave(void);

#endif
