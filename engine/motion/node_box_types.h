/* node_box_types - boxes in lanes, and sums of areas
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_NODE_BOX_TYPES_H
#define PLT_MOTION_NODE_BOX_TYPES_H

#include "engine/lanes/lanes.h"
#include "engine/tree/record.h"
#include "engine/tree/thesis/node.h"

typedef struct plt_box4 {
    f4 lo, hi;
} plt_box4;

static inline plt_box4 plt_box4_join(plt_box4 a, plt_box4 b) {
    const plt_box4 both = {f4_min(a.lo, b.lo), f4_max(a.hi, b.hi)};
    return both;
}

static inline plt_box4 plt_box4_load(const plt_box *b) {
    const float lo[4] = {b->lo[0], b->lo[1], b->lo[2], 0.0f};
    const float hi[4] = {b->hi[0], b->hi[1], b->hi[2], 0.0f};
    const plt_box4 box = {f4_load(lo), f4_load(hi)};
    return box;
}

/* Of two zeros the positive one: what a box is must not depend on the order of its making. */
static inline void plt_box4_store(plt_box4 b, plt_box *to) {
    float lo[4], hi[4];
    f4_store(lo, f4_add(b.lo, f4_zero()));
    f4_store(hi, f4_add(b.hi, f4_zero()));
    for (int a = 0; a < 3; a++) {
        to->lo[a] = lo[a];
        to->hi[a] = hi[a];
    }
}

/* What the areas of nodes say of a tree, in integers, so that sums are exact in any order. */
typedef struct plt_areas {
    uint64_t ratios; /* of each node's area to its children's together, in 1/65,536 */
    uint64_t sum;    /* of all nodes' areas, times scale */
    float scale;
    uint32_t is_wanted; /* 0: both sums stay 0, as nobody will build a tree by them */
} plt_areas;

/* A ratio is at most this: a node of children without area has no more to say. And an area that
 * is beyond its range is as large as that. */
#define PLT_RATIO_MOST 16.0f
#define PLT_AREA_MOST 1073741824.0f

/* Boxes around that area have 24 bits of it, and seven above. */
static inline float plt_areas_scale(const plt_box *box) {
    const float half_area = plt_box_half_area(box);
    return half_area > 0.0f ? 16777216.0f / half_area : 0.0f;
}

#endif
