/* racers - see racers.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/racers.h"

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

static void add_times(racer_time *to, const turns_side *of, uint64_t rays) {
    to->rays += (double)rays;
    to->hits += (double)of->hits;
    to->seconds += of->best;
    to->cycles += of->best_cycles;
}

int racers_run(racers *all, stage *s, unsigned rounds, counters *c, fail *f) {
    turns t = {.sides = all->count,
               .rounds = rounds,
               .rays = stage_rays(s),
               .scene = s->name,
               .kind = "primary",
               .counters = c};
    for (unsigned i = 0; i < all->count; i++) {
        t.side[i].name = all->racer[i].name;
        t.side[i].s = all->racer[i].s;
    }
    if (turns_run(&t, f) != 0) {
        return -1;
    }
    for (unsigned i = 0; i < all->count; i++) {
        add_times(&all->racer[i].sum, &t.side[i], t.rays.count);
    }
    return 0;
}
