/* planes - a box's planes, and where four lanes pass them
 *
 * Source: Kay and Kajiya, "Ray tracing complex scenes", 1986.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_PLANES_H
#define PLT_TRACE_PLANES_H

#include "engine/lanes/lanes.h"
#include "engine/trace/slabs.h"

/* A box's planes as each kind of packet wants them, in all four lanes. */
typedef struct plt_planes {
    f4 near[3], far[3]; /* PLT_ONE_ORIGIN: minus the common origin; PLT_MIXED: lo and hi */
} plt_planes;

/* lo, hi: x, y, z, and a number. */
PLT_INLINED void plt_planes_set(plt_planes *to, const plt_slab_array *slabs, f4 lo, f4 hi,
                                enum plt_coherence kind) {
    f4 near = lo, far = hi;
    if (kind != PLT_MIXED) {
        const m4 negative = m4_of_u4(u4_load(slabs->backwards));
        f4_swap(negative, &near, &far);
    }
    if (kind == PLT_ONE_ORIGIN) {
        near = f4_sub(near, f4_load(slabs->near_org));
        far = f4_sub(far, f4_load(slabs->far_org));
    }
    to->near[0] = f4_lane(near, 0);
    to->near[1] = f4_lane(near, 1);
    to->near[2] = f4_lane(near, 2);
    to->far[0] = f4_lane(far, 0);
    to->far[1] = f4_lane(far, 1);
    to->far[2] = f4_lane(far, 2);
}

/* Where the planes across an axis are passed, by rays of one sign each. */
PLT_INLINED void plt_plane_depths(const plt_planes *b, int a, const plt_group_slabs *s, f4 rate,
                                  f4 far_rate, enum plt_coherence kind, f4 *near, f4 *far) {
    f4 n = b->near[a], f = b->far[a];
    if (kind == PLT_MIXED) {
        const m4 negative = f4_lt(rate, f4_zero());
        n = f4_select(negative, b->far[a], b->near[a]);
        f = f4_select(negative, b->near[a], b->far[a]);
    }
    if (kind != PLT_ONE_ORIGIN) {
        n = f4_sub(n, f4_load(s->near_org[a]));
        f = f4_sub(f, f4_load(s->far_org[a]));
    }
    *near = f4_mul(n, rate);
    *far = f4_mul(f, far_rate);
}

#endif
