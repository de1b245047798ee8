/* kd_sweep - see kd_sweep.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/kd/kd_sweep.h"

#include <stdlib.h>

static int compare(const void *a, const void *b) {
    return kd_event_before(a, b) ? -1 : kd_event_before(b, a);
}

void kd_events_sort(kd_event *event, size_t count) {
    if (count > 2 * KD_FEW) {
        qsort(event, count, sizeof *event, compare);
        return;
    }
    for (size_t i = 1; i < count; i++) {
        const kd_event e = event[i];
        size_t to = i;
        for (; to > 0 && kd_event_before(&e, &event[to - 1]); to--) {
            event[to] = event[to - 1];
        }
        event[to] = e;
    }
}

void kd_sweep(const kd_cell *c, int axis, const kd_event *event, kd_cut *best) {
    const kd_areas areas = kd_areas_of(c, axis);
    const size_t events = 2 * (size_t)c->count;
    uint32_t low = 0, high = c->count;
    for (size_t i = 0; i < events;) {
        const float at = event[i].at;
        for (; i < events && event[i].at == at && (event[i].what & 1u) == 0; i++) {
            high--;
        }
        kd_cut_take(best, &areas, axis, at, (float)low, (float)high);
        for (; i < events && event[i].at == at; i++) {
            low++;
        }
    }
}

kd_cut kd_sweep_few(const kd_cell *c) {
    kd_cut best = kd_cost_of_leaf(c);
    for (int a = 0; a < 3; a++) {
        kd_event event[2 * KD_FEW];
        for (uint32_t i = 0; i < c->count; i++) {
            kd_event_put(&event[2 * i], &c->reference[i], i, a);
        }
        kd_events_sort(event, 2 * (size_t)c->count);
        kd_sweep(c, a, event, &best);
    }
    return best;
}
