/* split - one range of records into two
 *
 * Contract of a splitter: permutes records [begin, end) so that the left child
 * is [begin, middle) and the right one the rest, neither empty, and fills both
 * children's tight boxes. `box` is the tight box of the range, which holds at
 * least two records.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BUILDER_SPLIT_H
#define PLT_BUILDER_SPLIT_H

#include <stdint.h>

#include "engine/planelet_config.h"
#include "engine/tree/record.h"

typedef struct plt_split_range {
    plt_record *records;
    uint32_t begin, end;
    plt_box box;
} plt_split_range;

typedef struct plt_split {
    uint32_t middle;
    plt_box child[2];
} plt_split;

typedef struct plt_sah_bin {
    plt_box box;
    uint32_t count;
} plt_sah_bin;

typedef struct plt_sah_bins {
    plt_sah_bin bin[3][PLT_SAH_BINS];
    plt_box right_box[PLT_SAH_BINS]; /* of bins k and up, while an axis is swept */
    float right_cost[PLT_SAH_BINS];
} plt_sah_bins;

/* The thesis's builder: longest axis of the tight box, a triangle goes left
 * when the centre of its box lies below the middle (thesis, sections 2.2, 5.1). */
void plt_split_median(const plt_split_range *range, plt_split *split);

/* Binned surface area heuristic: Wald, "On fast construction of SAH-based
 * bounding volume hierarchies", 2007; cost area * count of both sides. */
void plt_split_sah(const plt_split_range *range, plt_sah_bins *bins, plt_split *split);

/* Halves by number along the longest axis (quickselect): when the depth runs out or no plane
 * separates anything. */
void plt_split_halves(const plt_split_range *range, plt_split *split);

/* Twice the centre of the record's box on an axis: exact to one rounding. */
static inline float plt_centre2(const plt_record *r, int axis) {
    const float p = plt_record_float(r, 0, axis), q = plt_record_float(r, 1, axis),
                s = plt_record_float(r, 2, axis);
    const float lo = p < q ? p : q, hi = p > q ? p : q;
    return (s < lo ? s : lo) + (s > hi ? s : hi);
}

static inline void plt_record_swap(plt_record *a, plt_record *b) {
    const plt_record t = *a;
    *a = *b;
    *b = t;
}

static inline int plt_longest_axis(const plt_box *b) {
    const float x = b->hi[0] - b->lo[0], y = b->hi[1] - b->lo[1], z = b->hi[2] - b->lo[2];
    return x >= y && x >= z ? 0 : (y >= z ? 1 : 2);
}

static inline plt_box plt_records_box(const plt_record *records, uint32_t begin, uint32_t end) {
    plt_box box = plt_box_empty();
    for (uint32_t i = begin; i < end; i++) {
        const plt_box b = plt_record_box(&records[i]);
        plt_box_add(&box, &b);
    }
    return box;
}

#endif
