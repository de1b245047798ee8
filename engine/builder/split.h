/* split - one range of items into two
 *
 * An item is a triangle that a builder can move: a float record of the thesis
 * tree, or an index into the lattice triangles of the compact blocks. Both are
 * split by the same heuristics, split_items.h.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BUILDER_SPLIT_H
#define PLT_BUILDER_SPLIT_H

#include <stdint.h>

#include "engine/builder/split_bins.h"
#include "engine/tree/record.h"

/* Items [begin, end), at least two, and how to split them. */
typedef struct plt_split_range {
    uint32_t begin, end;
    uint32_t depth;          /* inner nodes above */
    uint32_t leaf_triangles; /* K */
    uint8_t splits;          /* enum plt_splits */
} plt_split_range;

typedef struct plt_record_items {
    plt_record *records;
    plt_split_bins *bins;
} plt_record_items;

/* Permutes the records of a range, whose tight box is `box`, so that the left
 * child is [begin, middle) and the right one [middle, end), neither empty.
 * Returns the middle and fills both children's tight boxes. */
uint32_t plt_split_records(plt_record_items *items, const plt_split_range *range,
                           const plt_box *box, plt_box child[2]);

#if PLT_WITH_REBUILD
enum plt_splitting {
    PLT_SPLITTING_POINTS, /* centres: where bins lie */
    PLT_SPLITTING_BINS,
    PLT_SPLITTING_SIDES,  /* items to their side of the plane */
    PLT_SPLITTING_MEDIAN, /* ... of the median */
    PLT_SPLITTING_HALVES,
    PLT_SPLITTING_BOXES, /* both children's, where no bins have them */
    PLT_SPLITTING_DONE
};

/* A range that is split in steps; set `range` and `box`, its own. */
typedef struct plt_split_job {
    plt_split_range range;
    plt_box box;
    plt_box child[2]; /* results */
    uint32_t middle;
    uint8_t phase, is_in_round;
    uint32_t at, step;     /* the item that a phase goes on with, and how many it goes on by */
    uint32_t rounds;       /* of quickselect, within sides.begin and sides.end ... */
    uint32_t below, above; /* ... of one of them: what is equal to the pivot, or not known */
    float pivot;
    plt_split_box seen[2];
    plt_split_grid grid;
    plt_split_plane plane;
    plt_split_sides sides;
} plt_split_job;

/* plt_split_records, of more items than the surface area heuristic sorts, about *left items at a
 * time, each as often as a pass looks at it; what they are is taken off. PLT_MORE, or PLT_OK: it is
 * split. Until then, the items and their bins are its own. */
void plt_split_records_begin(plt_split_job *job);
int plt_split_records_some(plt_record_items *items, plt_split_job *job, uint32_t *left);
#endif

#if PLT_WITH_SUBTREES
/* The same at a middle that is given: by centres along the longest axis. */
uint32_t plt_split_records_at(plt_record_items *items, uint32_t begin, uint32_t middle,
                              uint32_t end, const plt_box *box, plt_box child[2]);
#endif

/* Levels that halving by count takes until lists hold at most `most`. */
static inline uint32_t plt_levels_needed(uint32_t count, uint32_t most) {
    uint32_t levels = 0;
    for (; count > most; count -= count / 2) {
        levels++;
    }
    return levels;
}

#endif
