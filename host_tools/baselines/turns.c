/* turns - see turns.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/turns.h"

#include <math.h>
#include <stdlib.h>

#include "board/hash.h"
#include "host_tools/base/clock.h"
#include "host_tools/base/heap.h"

static const plt_ray *lying_at(void *context, uint64_t first, uint32_t count) {
    (void)count;
    return (const plt_ray *)context + first;
}

turns_rays turns_rays_of(const plt_ray *rays, uint32_t count) {
    return (turns_rays){lying_at, (void *)(uintptr_t)rays, count};
}

static void look_at_hits(turns_side *s, const plt_hit *hits, uint32_t count, int any) {
    s->hash = hash_update(s->hash, (const uint8_t *)hits, count * sizeof *hits);
    for (uint32_t i = 0; i < count; i++) {
        s->hits += any ? hits[i].triangle != 0 : hits[i].triangle != PLT_MISS;
    }
}

static void show(turns *t) {
    if (t->bar != NULL) {
        progress_show(t->bar, t->passes);
    }
}

/* All rays once, in batches. The seconds of tracing; below 0: it failed. */
static double pass(turns *t, turns_side *s, plt_hit *hits, int is_first, fail *f) {
    double seconds = 0.0;
    uint32_t now;
    for (uint64_t at = 0; at < t->rays.count; at += now) {
        const uint64_t left = t->rays.count - at;
        now = left < TURNS_BATCH ? (uint32_t)left : TURNS_BATCH;
        const plt_ray *rays = t->rays.at(t->rays.context, at, now);
        if (t->counters != NULL) {
            counters_go(t->counters);
        }
        const double began = clock_processor_seconds();
        const int status = structure_trace(s->s, rays, hits, now, t->any, f);
        seconds += clock_processor_seconds() - began;
        if (t->counters != NULL) {
            counters_stop(t->counters);
        }
        if (status != 0) {
            return -1.0;
        }
        if (is_first) {
            look_at_hits(s, hits, now, t->any);
        }
        show(t);
    }
    t->passes++;
    return seconds > 1e-9 ? seconds : 1e-9;
}

/* The first of a side: its hits are those of the first side, and its counts are kept. */
static double first_pass(turns *t, turns_side *s, plt_hit *hits, fail *f) {
    s->hits = 0;
    s->hash = HASH_BASIS;
    structure_forget(s->s);
    const double seconds = pass(t, s, hits, 1, f);
    s->counts = structure_count(s->s);
    if (seconds >= 0.0 && s->hash != t->side[0].hash) {
        fail_set(f, t->scene, "hits of %s rays by %s differ from those by %s; please report this",
                 t->kind, s->name, t->side[0].name);
        return -1.0;
    }
    return seconds;
}

static void keep(const turns *t, turns_side *s, unsigned round, double seconds) {
    const counters *c = t->counters;
    s->seconds[round] = seconds;
    for (int i = 0; i < COUNTERS && c != NULL; i++) {
        s->counted[i] += c->count[i];
    }
    if (round == 0 || seconds < s->best) {
        s->best = seconds;
        s->best_cycles = c != NULL && c->file[COUNTER_CYCLES] >= 0
                             ? (double)c->count[COUNTER_CYCLES]
                             : (double)NAN;
    }
}

static int run_round(turns *t, unsigned round, plt_hit *hits, fail *f) {
    for (unsigned i = 0; i < t->sides; i++) {
        turns_side *s = &t->side[i];
        if (t->counters != NULL) {
            counters_clear(t->counters);
        }
        const double seconds =
            round == 0 && !t->is_tried ? first_pass(t, s, hits, f) : pass(t, s, hits, 0, f);
        if (seconds < 0.0) {
            return -1;
        }
        keep(t, s, round, seconds);
    }
    return 0;
}

static int run_all(turns *t, plt_hit *hits, fail *f) {
    for (unsigned i = 0; i < t->sides; i++) {
        for (int k = 0; k < COUNTERS; k++) {
            t->side[i].counted[k] = 0;
        }
        if (t->is_tried && first_pass(t, &t->side[i], hits, f) < 0.0) {
            return -1;
        }
    }
    for (unsigned round = 0; round < t->rounds; round++) {
        if (run_round(t, round, hits, f) != 0) {
            return -1;
        }
    }
    return 0;
}

int turns_run(turns *t, fail *f) {
    const uint64_t most = t->rays.count < TURNS_BATCH ? t->rays.count : TURNS_BATCH;
    plt_hit *hits = heap_get_zeroed(most * sizeof *hits + 1);
    if (hits == NULL) {
        return fail_set(f, "rays", "out of memory; choose a smaller --size");
    }
    const int status = run_all(t, hits, f);
    heap_drop(hits);
    return status;
}

static int by_size(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double turns_median(double *values, unsigned count) {
    qsort(values, count, sizeof *values, by_size);
    return 0.5 * (values[(count - 1) / 2] + values[count / 2]);
}
