/* note - a line for a person, not for a script
 *
 * SPDX-License-Identifier: MIT */
#ifndef NOTE_H
#define NOTE_H

/* One line on standard error, if that is a terminal. */
void note(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
