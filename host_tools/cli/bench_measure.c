/* bench_measure - see bench_measure.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/bench_measure.h"

#include <stdlib.h>

#include "board/hash.h"
#include "host_tools/base/clock.h"

enum { RAYS_PER_BATCH = 65536 }; /* a whole number of packets of every size */

/* All rays once, in batches; returns the seconds of tracing. */
static double trace_once(plt_engine *engine, const ray_set *s, int any, bench_meter *m) {
    double seconds = 0.0;
    for (uint32_t at = 0; at < s->count;) {
        const uint32_t left = s->count - at, now = left < RAYS_PER_BATCH ? left : RAYS_PER_BATCH;
        counters_go(&m->counters);
        const double began = clock_processor_seconds();
        plt_trace(engine, s->rays + at, m->hits + at, now, any); /* mapped: has no failures */
        seconds += clock_processor_seconds() - began;
        counters_stop(&m->counters);
        at += now;
        progress_show(&m->bar, m->passes);
    }
    m->passes++;
    return seconds;
}

static void look_at_hits(bench_row *row, const plt_hit *hits) {
    row->hash = hash_bytes((const uint8_t *)hits, (size_t)row->rays * sizeof *hits);
    row->hits = 0;
    for (uint32_t i = 0; i < row->rays; i++) {
        row->hits += row->any ? hits[i].triangle != 0 : hits[i].triangle != PLT_MISS;
    }
}

static int by_size(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double rate(const bench_row *row, double seconds) {
    return row->rays / (seconds > 1e-9 ? seconds : 1e-9);
}

void bench_measure(bench_row *row, plt_engine *engine, const ray_set *rays, bench_meter *m) {
    double seconds[BENCH_REPEAT_MOST];
    const unsigned n = m->repeat;
    row->rays = rays->count;
    plt_stats_reset(engine);
    trace_once(engine, rays, row->any, m);
    plt_stats_get(engine, &row->stats);
    look_at_hits(row, m->hits);
    counters_clear(&m->counters);
    for (unsigned i = 0; i < n; i++) {
        seconds[i] = trace_once(engine, rays, row->any, m);
    }
    for (int i = 0; i < COUNTERS; i++) {
        row->counted[i] = m->counters.count[i] / n;
    }
    qsort(seconds, n, sizeof seconds[0], by_size);
    row->most = rate(row, seconds[0]);
    row->least = rate(row, seconds[n - 1]);
    row->median = rate(row, 0.5 * (seconds[(n - 1) / 2] + seconds[n / 2]));
}
