/* racers - see racers.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/racers.h"

#include <math.h>

#include "board/hash.h"
#include "host_tools/base/clock.h"

int racers_add(racers *all, const char *text, const mesh *m, const char *name, fail *f) {
    structure_options options = {.packet_side = 0};
    const structure_kind *kind = structure_read(text, name, &options, f);
    racer *r = &all->racer[all->count];
    r->name = text;
    r->s = kind != NULL ? structure_open(kind, m, &options, name, f) : NULL;
    all->count += r->s != NULL;
    return r->s != NULL ? 0 : -1;
}

void racers_close(racers *all) {
    for (unsigned i = 0; i < all->count; i++) {
        structure_close(all->racer[i].s);
    }
    all->count = 0;
}

int racers_move(racers *all, const mesh *m, fail *f) {
    int status = 0;
    for (unsigned i = 0; i < all->count && status == 0; i++) {
        status = structure_move(all->racer[i].s, m, f);
    }
    return status;
}

/* The time of one round; `best` becomes the shorter. */
static int trace(racer *r, stage *s, counters *c, racer_time *best, fail *f) {
    counters_clear(c);
    counters_go(c);
    const double began = clock_processor_seconds();
    const int status = structure_trace(r->s, s->rays, s->hits, s->count, 0, f);
    const double seconds = clock_processor_seconds() - began;
    counters_stop(c);
    if (best->seconds == 0.0 || seconds < best->seconds) {
        best->seconds = seconds > 1e-9 ? seconds : 1e-9;
        best->cycles =
            c->file[COUNTER_CYCLES] >= 0 ? (double)c->count[COUNTER_CYCLES] : (double)NAN;
    }
    return status;
}

static uint64_t look_at_hits(const stage *s, racer_time *best) {
    best->hits = 0.0;
    for (uint32_t i = 0; i < s->count; i++) {
        best->hits += s->hits[i].triangle != PLT_MISS;
    }
    return hash_bytes((const uint8_t *)s->hits, s->count * sizeof *s->hits);
}

static void add_times(racer_time *to, const racer_time *t) {
    to->rays += t->rays;
    to->hits += t->hits;
    to->seconds += t->seconds;
    to->cycles += t->cycles;
}

int racers_run(racers *all, stage *s, unsigned rounds, counters *c, fail *f) {
    racer_time best[RACERS_MOST] = {{0}};
    uint64_t first = 0;
    for (unsigned round = 0; round < rounds; round++) {
        for (unsigned i = 0; i < all->count; i++) {
            if (trace(&all->racer[i], s, c, &best[i], f) != 0) {
                return -1;
            }
            const uint64_t hash = look_at_hits(s, &best[i]);
            first = round == 0 && i == 0 ? hash : first;
            if (hash != first) {
                return fail_set(f, s->name, "%s has other hits than %s; please report this",
                                all->racer[i].name, all->racer[0].name);
            }
        }
    }
    for (unsigned i = 0; i < all->count; i++) {
        best[i].rays = s->count;
        add_times(&all->racer[i].sum, &best[i]);
    }
    return 0;
}
