/* bench_measure - see bench_measure.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/bench_measure.h"

int bench_measure(bench_row *row, built_structure *s, const ray_set *rays, bench_meter *m,
                  fail *f) {
    turns t = {.sides = 1,
               .rounds = m->repeat,
               .is_tried = 1,
               .any = row->any,
               .rays = turns_rays_of(rays->rays, rays->count),
               .scene = row->scene,
               .kind = ray_kind_names[row->kind],
               .counters = &m->counters,
               .bar = &m->bar,
               .passes = m->passes};
    turns_side *side = &t.side[0];
    side->s = s;
    side->name = row->structure;
    row->rays = rays->count;
    if (turns_run(&t, f) != 0) {
        return -1;
    }
    m->passes = t.passes;
    row->hits = side->hits;
    row->hash = side->hash;
    row->stats = side->counts;
    for (int i = 0; i < COUNTERS; i++) {
        row->counted[i] = side->counted[i] / m->repeat;
    }
    row->median = row->rays / turns_median(side->seconds, m->repeat); /* sorts them */
    row->most = row->rays / side->seconds[0];
    row->least = row->rays / side->seconds[m->repeat - 1];
    return 0;
}
