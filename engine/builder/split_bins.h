/* split_bins - scratch of the surface area heuristic, and boxes as a splitter takes them
 *
 * A row is the box of a bin, or of an item of a short range, on each of the three axes.
 *
 * Where four lanes are one register, boxes are in lanes, x y z and one that means nothing,
 * and a sweep takes the three rows of one number at once. Elsewhere both are plain loops:
 * the same numbers, in the same order, for less than half of the code that lanes would take.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BUILDER_SPLIT_BINS_H
#define PLT_BUILDER_SPLIT_BINS_H

#include <stdint.h>
#include <string.h>

#include "engine/base/box.h"
#include "engine/lanes/lanes.h"
#include "engine/planelet_config.h"

/* 128 bytes per bin. */
typedef struct plt_split_bins {
    float lo[3][PLT_SAH_BINS][4], hi[3][PLT_SAH_BINS][4]; /* by axis: boxes, x y z and nothing */
    uint32_t count[PLT_SAH_BINS][4];                      /* of items, by axis */
    float right_cost[PLT_SAH_BINS][4];                    /* of rows k and up, by axis */
} plt_split_bins;

/* Twice the centre to a bin: (centre2 - lo) * scale. Four numbers, for lanes; the last mean
 * nothing. */
typedef struct plt_split_grid {
    float lo[4], scale[4];
    uint32_t bins;
} plt_split_grid;

/* Whether an item's bin on an axis is `row` or above. */
typedef struct plt_split_plane {
    int axis;
    float lo, scale, row;
} plt_split_plane;

enum { PLT_SPLIT_BLOCK = 32 };

/* Items of a block that are on the wrong side, found without a jump that depends on where
 * they are; those from `next` on wait for one of the other side. */
typedef struct plt_split_wrong {
    uint8_t at[PLT_SPLIT_BLOCK];
    uint32_t next, count;
} plt_split_wrong;

/* Items [begin, end) that may be on either side, but for the blocks at both ends. */
typedef struct plt_split_sides {
    uint32_t begin, end;
    plt_split_wrong left, right;
} plt_split_sides;

/* What is small in lanes and large without them, and used in several places. */
#if PLT_LANES_REGISTERS
#define PLT_SPLIT_APART inline
#else
#define PLT_SPLIT_APART __attribute__((noinline, unused))
#endif

#if PLT_LANES_REGISTERS

typedef struct plt_split_box {
    f4 lo, hi;
} plt_split_box;

static inline plt_split_box plt_split_box_empty(void) {
    const plt_split_box b = {f4_all(PLT_BOX_FAR), f4_all(-PLT_BOX_FAR)};
    return b;
}

static inline void plt_split_box_add(plt_split_box *b, const plt_split_box *c) {
    b->lo = f4_min(c->lo, b->lo);
    b->hi = f4_max(c->hi, b->hi);
}

/* Twice the centre; the last number means nothing. */
static inline void plt_split_centre2(const plt_split_box *b, float centre2[4]) {
    f4_store(centre2, f4_add(b->lo, b->hi));
}

static inline plt_split_box plt_split_row(const plt_split_bins *bins, int axis, uint32_t k) {
    const plt_split_box b = {f4_load(bins->lo[axis][k]), f4_load(bins->hi[axis][k])};
    return b;
}

static inline void plt_split_set_row(plt_split_bins *bins, int axis, uint32_t k,
                                     const plt_split_box *b) {
    f4_store(bins->lo[axis][k], b->lo);
    f4_store(bins->hi[axis][k], b->hi);
}

#else

typedef plt_box plt_split_box;

static inline plt_split_box plt_split_box_empty(void) {
    return plt_box_empty();
}

static PLT_SPLIT_APART void plt_split_box_add(plt_split_box *b, const plt_split_box *c) {
    plt_box_add(b, c);
}

static inline void plt_split_centre2(const plt_split_box *b, float centre2[4]) {
    for (int a = 0; a < 3; a++) {
        centre2[a] = b->lo[a] + b->hi[a];
    }
}

static inline plt_split_box plt_split_row(const plt_split_bins *bins, int axis, uint32_t k) {
    plt_split_box b;
    memcpy(b.lo, bins->lo[axis][k], sizeof b.lo);
    memcpy(b.hi, bins->hi[axis][k], sizeof b.hi);
    return b;
}

static inline void plt_split_set_row(plt_split_bins *bins, int axis, uint32_t k,
                                     const plt_split_box *b) {
    memcpy(bins->lo[axis][k], b->lo, sizeof b->lo);
    memcpy(bins->hi[axis][k], b->hi, sizeof b->hi);
}

#endif

#endif
