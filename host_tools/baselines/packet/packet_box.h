/* packet_box - a packet against a box: early hit, frustum miss, and the rest
 *
 * The first active rays, a group of four, are asked first: where one of them meets the box all go
 * on, and no other is asked (early hit). Where none does, and the hull of all rays misses the box,
 * nobody goes on (frustum miss). Else the others are asked in turn. Both tests may be left out, and
 * then every active ray is asked, as in the thesis.
 *
 * A box is x, y, z in lanes, and a number that means nothing in the fourth.
 *
 * Sources: Wald, Boulos, Shirley 2007, section 4; Karrenberg 2007, sections 3.5.2 and 6.3.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_PACKET_BOX_H
#define BASELINES_PACKET_BOX_H

#include "engine/trace/planes.h"
#include "host_tools/baselines/packet/packet_state.h"

typedef struct packet_steps {
    uint8_t early;   /* 1: the first active rays may answer for all */
    uint8_t frustum; /* 1: the hull may, that none meets the box */
} packet_steps;

/* A box of memory; nothing beside it is read. */
static inline f4 packet_box_lo(const plt_box *b) {
    return f4_load(b->lo);
}

static inline f4 packet_box_hi(const plt_box *b) {
    const f4 v = f4_load(&b->lo[2]);
    return f4_rotate(v);
}

/* Lanes of a group, active ones, that meet a box whose planes are set for the packet's kind. */
PLT_INLINED unsigned packet_group_meets(const packet_state *p, unsigned group, const plt_planes *b,
                                        enum plt_coherence kind) {
    const plt_group_slabs *s = &p->rays.slabs.group[group];
    f4 n[3], f[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 rate = f4_load(s->rdir[a]);
        plt_plane_depths(b, a, s, rate, rate, kind, &n[a], &f[a]);
    }
    const f4 enter = f4_max(f4_max(n[0], n[1]), f4_max(n[2], f4_load(s->tmin)));
    const f4 leave = f4_min(f4_min(f[0], f[1]), f4_min(f[2], f4_load(s->tmax)));
    return m4_mask(f4_le(enter, leave));
}

/* No ray of the packet meets the box, whichever are active. */
PLT_INLINED int packet_hull_misses(const packet_hull *h, f4 lo, f4 hi) {
    const m4 back = m4_of_u4(u4_load(h->backwards)), part = m4_of_u4(u4_load(h->has_part));
    const f4 least = f4_load(h->rate_least), most = f4_load(h->rate_most), zero = f4_zero();
    const f4 near = f4_sub(f4_select(back, f4_neg(hi), lo), f4_load(h->near_most));
    const f4 far = f4_sub(f4_select(back, f4_neg(lo), hi), f4_load(h->far_least));
    const f4 into = f4_mul(near, f4_select(f4_lt(near, zero), most, least));
    const f4 out = f4_mul(far, f4_select(f4_lt(far, zero), least, most));
    const f4 enter = f4_select(part, into, f4_load(h->enter));
    const f4 leave = f4_select(part, out, f4_load(h->leave));
    return f4_min_lane(leave) < -f4_min_lane(f4_neg(enter));
}

/* Whether rays of the range may meet the box; it becomes those that may. */
PLT_INLINED int packet_meet_range(packet_state *p, f4 lo, f4 hi, enum plt_coherence kind,
                                  packet_steps steps, packet_range *r) {
    plt_planes b;
    plt_mask left = packet_range_groups(r) & p->rays.active;
    plt_planes_set(&b, &p->rays.slabs, lo, hi, kind);
    if (steps.early && left != 0) {
        p->counts.group_tests++;
        r->first = (uint8_t)plt_mask_first(left);
        if (packet_group_meets(p, r->first, &b, kind) != 0) {
            p->counts.early_hits++;
            return 1;
        }
        left &= left - 1;
    }
    if (steps.frustum && packet_hull_misses(&p->hull, lo, hi)) {
        p->counts.frustum_misses++;
        return 0;
    }
    plt_mask met = 0;
    for (; left != 0 && (met == 0 || !steps.early); left &= left - 1) {
        const unsigned g = plt_mask_first(left);
        p->counts.group_tests++;
        met |= plt_mask_of(g, packet_group_meets(p, g, &b, kind) != 0);
    }
    if (met != 0) {
        r->first = (uint8_t)plt_mask_first(met);
        r->last = steps.early ? r->last : (uint8_t)plt_mask_last(met);
    }
    return met != 0;
}

/* Groups that meet the box, all of them asked, of a range whose first does (packet_meet_range). */
PLT_INLINED plt_mask packet_groups_in(packet_state *p, f4 lo, f4 hi, enum plt_coherence kind,
                                      const packet_range *r) {
    plt_planes b;
    plt_mask left = packet_range_groups(r) & p->rays.active, met = left & (~left + 1u);
    plt_planes_set(&b, &p->rays.slabs, lo, hi, kind);
    for (left &= left - 1; left != 0; left &= left - 1) {
        const unsigned g = plt_mask_first(left);
        p->counts.group_tests++;
        met |= plt_mask_of(g, packet_group_meets(p, g, &b, kind) != 0);
    }
    return met;
}

/* Whether rays of `in` may meet the box, and those that may. */
PLT_INLINED int packet_meet_bits(packet_state *p, f4 lo, f4 hi, enum plt_coherence kind,
                                 packet_steps steps, const packet_mask *in, packet_mask *out) {
    plt_planes b;
    unsigned g = packet_mask_next(in, 0), met = 0;
    plt_planes_set(&b, &p->rays.slabs, lo, hi, kind);
    packet_mask_clear(out);
    if (steps.early && g < PACKET_GROUPS) {
        p->counts.group_tests++;
        met = packet_group_meets(p, g, &b, kind) & packet_mask_lanes(in, g);
        if (met != 0) {
            p->counts.early_hits++;
            *out = *in;
            return 1;
        }
        g = packet_mask_next(in, g + 1);
    }
    if (steps.frustum && packet_hull_misses(&p->hull, lo, hi)) {
        p->counts.frustum_misses++;
        return 0;
    }
    for (; g < PACKET_GROUPS; g = packet_mask_next(in, g + 1)) {
        const unsigned lanes = packet_group_meets(p, g, &b, kind) & packet_mask_lanes(in, g);
        p->counts.group_tests++;
        packet_mask_add(out, g, lanes);
        met |= lanes;
    }
    return met != 0;
}

#endif
