/* packet_triangles - a packet against the triangles of a leaf
 *
 * By the engine's own test of groups, which keeps the lesser of (t, id) in any order.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_PACKET_TRIANGLES_H
#define BASELINES_PACKET_TRIANGLES_H

#include "engine/trace/leaf_records.h"
#include "host_tools/baselines/packet/packet_state.h"

/* Records from `first` up to one whose last bit is set, against `groups`. `longest`: at least the
 * longest side of any's box. `active`: the rays that are not masked out, for counting. */
static inline void packet_meet_triangles(packet_state *p, const plt_record *first, float longest,
                                         plt_mask groups, uint32_t active) {
    groups &= p->rays.active;
    if (groups == 0) {
        return;
    }
    const uint32_t count = plt_records_groups(&p->rays, first, 1, longest, groups);
    packet_count_triangles(&p->counts, count, p->count, active);
    p->counts.triangle_tests += (uint64_t)count * plt_mask_count(groups);
    packet_narrow(p);
}

/* Any hit: nothing more is sought. */
static inline int packet_is_done(const packet_state *p) {
    return p->rays.active == 0;
}

#endif
