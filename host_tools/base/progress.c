/* progress - a line on standard error for work that takes seconds
 *
 * Keeps: nothing is written unless standard error is a terminal.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/progress.h"

#include <stdio.h>
#include <unistd.h>

#include "host_tools/base/clock.h"

static const double FIRST_SECONDS = 1.0;
static const double STEP_SECONDS = 0.1;

void progress_begin(progress *p, const char *what, uint64_t total) {
    const double now = clock_seconds();
    *p = (progress){.what = what, .total = total, .began = now, .on = isatty(STDERR_FILENO)};
}

void progress_show(progress *p, uint64_t done) {
    if (!p->on) {
        return;
    }
    const double now = clock_seconds();
    if (now - p->began < FIRST_SECONDS || now - p->shown < STEP_SECONDS) {
        return;
    }
    p->shown = now;
    fprintf(stderr, "\r\033[K%s: ", p->what);
    if (p->total) {
        fprintf(stderr, "%.0f %%", 100.0 * (double)done / (double)p->total);
    } else {
        fprintf(stderr, "%llu", (unsigned long long)done);
    }
    fflush(stderr);
}

void progress_end(progress *p) {
    if (p->on && p->shown > 0) {
        fprintf(stderr, "\r\033[K");
        fflush(stderr);
    }
    p->on = 0;
}
