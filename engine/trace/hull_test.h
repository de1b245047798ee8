/* hull_test - four lanes, of a hull or of a group, against a box
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_HULL_TEST_H
#define PLT_TRACE_HULL_TEST_H

#include "engine/trace/hulls.h"
#include "engine/trace/planes.h"

#if PLT_WITH_HULLS

static inline unsigned plt_lane_first(unsigned lanes) {
    return (unsigned)__builtin_ctz(lanes);
}

/* A hull's lanes may run both ways: each plane that is near to some ray counts. */
PLT_INLINED void plt_mixed_depths(const plt_planes *b, int a, const plt_hull *h, f4 *near,
                                  f4 *far) {
    const f4 lo = f4_sub(b->near[a], f4_load(h->slabs.near_org[a]));
    const f4 hi = f4_sub(b->far[a], f4_load(h->slabs.far_org[a]));
    const f4 rate = f4_load(h->far_rate[a]);
    const f4 leave = f4_mul(f4_select(f4_lt(rate, f4_zero()), lo, hi), rate);
    *near = f4_max(f4_mul(lo, f4_load(h->slabs.rdir[a])), f4_mul(hi, f4_load(h->back_rate[a])));
    *far = f4_select(f4_eq(rate, f4_zero()), f4_all(__builtin_inff()), leave);
}

/* Four lanes to be tested: a hull's, or a group's rays. */
typedef struct plt_four {
    const plt_group_slabs *slabs;
    const float (*far_rate)[4];
    const plt_hull *hull; /* NULL: they are rays */
} plt_four;

/* Those of a hull, or behind the hulls of a group whose slabs are set. */
static inline plt_four plt_four_of(const plt_packet *p, unsigned hull) {
    if (hull < p->first_group) {
        const plt_four four = {&p->hull[hull].slabs, p->hull[hull].far_rate, &p->hull[hull]};
        return four;
    }
    const plt_group_slabs *s = &p->slabs.group[hull - p->first_group];
    const plt_four four = {s, s->rdir, NULL};
    return four;
}

/* Lanes that meet the box, and at which depth (of rays: t). */
PLT_INLINED unsigned plt_four_meet(const plt_four *four, const plt_planes *b,
                                   enum plt_coherence kind, f4 *enter) {
    f4 n[3], f[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        if (kind == PLT_MIXED && four->hull != NULL) {
            plt_mixed_depths(b, a, four->hull, &n[a], &f[a]);
        } else {
            plt_plane_depths(b, a, four->slabs, f4_load(four->slabs->rdir[a]),
                             f4_load(four->far_rate[a]), kind, &n[a], &f[a]);
        }
    }
    *enter = f4_max(f4_max(n[0], n[1]), f4_max(n[2], f4_load(four->slabs->tmin)));
    const f4 leave = f4_min(f4_min(f[0], f[1]), f4_min(f[2], f4_load(four->slabs->tmax)));
    return m4_mask(f4_le(*enter, leave));
}

#endif

#endif
