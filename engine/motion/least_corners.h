/* least_corners - which corner of each of four triangles comes first
 *
 * Canonical order (tree/canonical.h) without a jump. Coordinates that are equal are every other
 * triangle of a mesh that was cut out of a grid, and which ones cannot be predicted.
 *
 * Where four lanes are one register.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_LEAST_CORNERS_H
#define PLT_MOTION_LEAST_CORNERS_H

#include "engine/lanes/lanes.h"
#include "engine/tree/primitive_id.h"

/* One corner of each. */
typedef struct plt_corner4 {
    f4 x, y, z;
} plt_corner4;

/* From x y z and a lane that means nothing. */
static inline plt_corner4 plt_corner4_of(f4 p, f4 q, f4 r, f4 s) {
    f4_transpose(&p, &q, &r, &s);
    const plt_corner4 corner = {p, q, r};
    return corner;
}

/* By x, then y, then z. */
static inline m4 plt_corner4_below(const plt_corner4 *a, const plt_corner4 *b) {
    const m4 z = m4_and(f4_eq(a->y, b->y), f4_lt(a->z, b->z));
    const m4 y = m4_and(f4_eq(a->x, b->x), m4_or(f4_lt(a->y, b->y), z));
    return m4_or(f4_lt(a->x, b->x), y);
}

/* 0, 1 or 2 for each, as plt_canonical_first: of equals the first; and rotations, as
 * plt_canonical_rotation, where id words have them. */
typedef struct plt_least4 {
    uint32_t first[4], rotation[4];
} plt_least4;

static inline void plt_least_corners(plt_least4 *to, const plt_corner4 c[3]) {
    const m4 last = m4_and(plt_corner4_below(&c[2], &c[0]), plt_corner4_below(&c[2], &c[1])),
             middle = plt_corner4_below(&c[1], &c[0]);
    const u4 zero = u4_all(0), one = u4_all(1u << PLT_PRIMITIVE_ROTATION_SHIFT),
             two = u4_all(2u << PLT_PRIMITIVE_ROTATION_SHIFT);
    u4_store(to->first, u4_select(last, u4_all(2), u4_select(middle, u4_all(1), zero)));
    u4_store(to->rotation, u4_select(last, one, u4_select(middle, two, zero)));
}

#endif
