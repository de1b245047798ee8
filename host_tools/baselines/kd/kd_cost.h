/* kd_cost - the surface area heuristic for cells
 *
 * A step costs 1, a triangle KD_TEST, and a cut that takes away nothing but empty space counts for
 * a fifth less. All boxes have some width (kd_whole), so that no plane lies in one.
 *
 * Source: MacDonald, Booth, "Heuristics for ray tracing using space subdivision", 1990; Hurley,
 * Kapustin, Reshetov, Soupikov, "Fast ray tracing for modern general purpose CPU", 2002 (the
 * bonus).
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_KD_COST_H
#define BASELINES_KD_COST_H

#include "host_tools/baselines/kd/kd_cell.h"

#define KD_TEST 1.5f
#define KD_BONUS 0.8f

/* Half the surface of the cell, and how the lower part's grows with its length along an axis. */
typedef struct kd_areas {
    float lo, hi, whole, face, around;
} kd_areas;

static inline kd_areas kd_areas_of(const kd_cell *c, int axis) {
    const int b = axis < 2 ? axis + 1 : 0, d = axis > 0 ? axis - 1 : 2;
    const float x = c->hi[axis] - c->lo[axis], y = c->hi[b] - c->lo[b], z = c->hi[d] - c->lo[d];
    const kd_areas a = {c->lo[axis], c->hi[axis], x * (y + z) + y * z, y * z, y + z};
    return a;
}

/* Of a cut at `at` with `low` triangles in the lower and `high` in the upper part. */
static inline float kd_cost(const kd_areas *a, float at, float low, float high) {
    const float below = a->face + (at - a->lo) * a->around,
                above = a->face + (a->hi - at) * a->around;
    const float cost = 1.0f + KD_TEST * (below * low + above * high) / a->whole;
    return low == 0.0f || high == 0.0f ? KD_BONUS * cost : cost;
}

static inline kd_cut kd_cost_of_leaf(const kd_cell *c) {
    const kd_cut none = {KD_TEST * (float)c->count, 0.0f, 0, 0};
    return none;
}

static inline void kd_cut_take(kd_cut *best, const kd_areas *a, int axis, float at, float low,
                               float high) {
    const float cost = kd_cost(a, at, low, high);
    if (a->lo < at && at < a->hi && cost < best->cost) {
        *best = (kd_cut){cost, at, (uint8_t)axis, 1};
    }
}

#endif
