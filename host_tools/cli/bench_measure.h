/* bench_measure - one kind of ray in one mode, several times
 *
 * SPDX-License-Identifier: MIT */
#ifndef BENCH_MEASURE_H
#define BENCH_MEASURE_H

#include "host_tools/base/progress.h"
#include "host_tools/cli/bench_rows.h"

enum { BENCH_REPEAT_MOST = 1000 };

typedef struct bench_meter {
    unsigned repeat; /* 1 .. BENCH_REPEAT_MOST */
    counters counters;
    plt_hit *hits; /* room for the rays */
    progress bar;
    uint64_t passes; /* all so far */
} bench_meter;

/* Traces `rays` once to see what comes of it, then `repeat` times by the clock: fills what
 * the row says came of it, but for arena_bytes. */
void bench_measure(bench_row *row, plt_engine *engine, const ray_set *rays, bench_meter *meter);

#endif
