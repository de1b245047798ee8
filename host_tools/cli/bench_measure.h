/* bench_measure - one kind of ray through one structure, several times
 *
 * SPDX-License-Identifier: MIT */
#ifndef BENCH_MEASURE_H
#define BENCH_MEASURE_H

#include "host_tools/baselines/turns.h"
#include "host_tools/cli/bench_rows.h"

typedef struct bench_meter {
    unsigned repeat; /* 1 .. TURNS_ROUNDS_MOST */
    counters counters;
    progress bar;
    uint64_t passes; /* all so far */
} bench_meter;

/* Traces `rays` once to see what comes of it, then `repeat` times by the clock: fills what
 * the row says came of it, but for arena_bytes and build_seconds. -1: no memory. */
int bench_measure(bench_row *row, built_structure *s, const ray_set *rays, bench_meter *meter,
                  fail *f);

#endif
