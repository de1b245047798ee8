/* progress - a line on standard error for work that takes seconds
 *
 * Nothing is printed before one second has passed, nor when standard error is
 * not a terminal. After that the line is rewritten at most ten times per
 * second, and erased at the end.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PROGRESS_H
#define PROGRESS_H
#include <stdint.h>

typedef struct progress {
    const char *what; /* "packing bunny.ply" */
    uint64_t total;   /* 0: unknown */
    double began, shown;
    int on;
} progress;

void progress_begin(progress *p, const char *what, uint64_t total);
void progress_show(progress *p, uint64_t done);
void progress_end(progress *p);

#endif
