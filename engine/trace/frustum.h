/* frustum - what lies beside all rays of some groups of a packet
 *
 * Rays from one point along one axis are points in the plane of their slopes
 * (packet.h); those of some groups lie in a rectangle. A triangle before them whose
 * corners lie on the far side of one of its four edges meets none of them. That is cheaper to
 * see than to test four rays, and it is told once for all groups.
 *
 * Margin: DESIGN.md, section 7.6: whatever the test of a ray would accept is inside.
 *
 * Source: Reshetov, Soupikov, Hurley, "Multi-level ray tracing algorithm", 2005, and
 * Boulos, Wald, Shirley, "Geometric and arithmetic culling methods for entire ray
 * packets", 2006 (corner rays); the outcodes are Cohen's and Sutherland's.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_FRUSTUM_H
#define PLT_TRACE_FRUSTUM_H

#include "engine/trace/packet.h"

typedef struct plt_frustum {
    f4 by_axis[3]; /* what the coordinates are multiplied by, a lane for each edge */
    f4 org[3];
    f4 out;           /* below it: beside */
    float way, start; /* of the rays along the axis: 1 or -1; where they start */
    unsigned axis;
} plt_frustum;

/* 0: the packet's rays do not have one. */
int plt_frustum_set(plt_frustum *rim, const plt_packet *packet, plt_mask groups);

/* Bits 0 .. 3: the edges that the point lies outside of; bit 4: it lies behind where
 * the rays start. */
static inline unsigned plt_frustum_outcode(const plt_frustum *r, const float at[3]) {
    const f4 x = f4_mul(r->by_axis[0], f4_sub(f4_all(at[0]), r->org[0]));
    const f4 y = f4_mul(r->by_axis[1], f4_sub(f4_all(at[1]), r->org[1]));
    const f4 z = f4_mul(r->by_axis[2], f4_sub(f4_all(at[2]), r->org[2]));
    const unsigned behind = r->way * (at[r->axis] - r->start) < 0.0f;
    return m4_mask(f4_lt(f4_add(f4_add(x, y), z), r->out)) | behind << 4;
}

/* Does no ray of the groups meet the triangle of these three corners' codes? */
static inline int plt_frustum_culls(unsigned a, unsigned b, unsigned c) {
    return (a & b & c & 15u) != 0 && ((a | b | c) & 16u) == 0;
}

#endif
