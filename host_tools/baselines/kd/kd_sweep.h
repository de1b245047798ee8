/* kd_sweep - the best cut by the surface area heuristic: all places where boxes begin or end
 *
 * Source: Wald, Havran, "On building fast kd-trees for ray tracing, and on doing that in
 * O(N log N)", 2006.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_KD_SWEEP_H
#define BASELINES_KD_SWEEP_H

#include "host_tools/baselines/kd/kd_cost.h"

/* A box begins or ends. In order by place, ends first. */
typedef struct kd_event {
    float at;
    uint32_t what; /* 2 * reference, + 1 where it begins */
} kd_event;

static inline int kd_event_before(const kd_event *a, const kd_event *b) {
    return a->at < b->at || (a->at == b->at && (a->what & 1u) < (b->what & 1u));
}

/* Both events of reference `i` along an axis. */
static inline void kd_event_put(kd_event to[2], const kd_reference *r, uint32_t i, int axis) {
    to[0] = (kd_event){r->lo[axis], 2 * i + 1};
    to[1] = (kd_event){r->hi[axis], 2 * i};
}

void kd_events_sort(kd_event *event, size_t count);

/* Takes the best cut along an axis into `best`, from 2 * c->count events in order. */
void kd_sweep(const kd_cell *c, int axis, const kd_event *event, kd_cut *best);

/* Of a cell of KD_FEW triangles at most, which need no memory. */
enum { KD_FEW = 16 };
kd_cut kd_sweep_few(const kd_cell *c);

#endif
