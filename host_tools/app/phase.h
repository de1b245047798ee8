/* phase - a line on standard error during a call that reports no progress
 *
 * Nothing is printed in the first second, nor when standard error is not a
 * terminal. After that "reading bunny.ply, 2 s" counts the seconds, and the
 * line is erased at the end. One phase at a time. (For work that knows how far
 * it is: base/progress.h.)
 *
 * SPDX-License-Identifier: MIT */
#ifndef PHASE_H
#define PHASE_H

void phase_begin(const char *doing, const char *what); /* "reading", "bunny.ply" */
void phase_end(void);

#endif
