/* frustum - culls triangles that lie outside the hull of some groups' rays
 *
 * Rays from one origin along one axis are points in the plane of their slopes
 * (packet.h); those of some groups lie in a rectangle, whose four edges and the origin
 * span a frustum. A triangle in front of the origin whose corners all lie outside of
 * one of the frustum's planes meets none of the rays. That is cheaper than testing
 * four rays, and one test serves all groups.
 *
 * Margin: DESIGN.md, section 7.6: whatever the test of a ray would accept is inside.
 *
 * Source: Reshetov, Soupikov, Hurley, "Multi-level ray tracing algorithm", 2005, and
 * Boulos, Wald, Shirley, "Geometric and arithmetic culling methods for entire ray
 * packets", 2006 (corner rays); outcodes as in Cohen's and Sutherland's line clipping.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_FRUSTUM_H
#define PLT_TRACE_FRUSTUM_H

#include "engine/trace/packet.h"

/* The four side planes, a lane each. */
typedef struct plt_frustum {
    f4 normal[3]; /* the planes go through org */
    f4 org[3];
    f4 margin;             /* a point whose distance is below it lies outside of that plane */
    float sign, org_along; /* of the rays along the axis: 1 or -1; where they start */
    unsigned axis;
} plt_frustum;

/* 0: the packet's rays do not have one. */
int plt_frustum_set(plt_frustum *frustum, const plt_packet *packet, plt_mask groups);

/* Bits 0 .. 3: the planes that the point lies outside of; bit 4: it lies behind the
 * origin. */
static inline unsigned plt_frustum_outcode(const plt_frustum *f, const float at[3]) {
    const f4 x = f4_mul(f->normal[0], f4_sub(f4_all(at[0]), f->org[0]));
    const f4 y = f4_mul(f->normal[1], f4_sub(f4_all(at[1]), f->org[1]));
    const f4 z = f4_mul(f->normal[2], f4_sub(f4_all(at[2]), f->org[2]));
    const unsigned behind = f->sign * (at[f->axis] - f->org_along) < 0.0f;
    return m4_mask(f4_lt(f4_add(f4_add(x, y), z), f->margin)) | behind << 4;
}

/* No ray of the groups meets a triangle whose corners have these outcodes. */
static inline int plt_frustum_culls(unsigned a, unsigned b, unsigned c) {
    return (a & b & c & 15u) != 0 && ((a | b | c) & 16u) == 0;
}

#endif
