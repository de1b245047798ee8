/* split_items - the splitting heuristics, once for whatever can be split
 *
 * Written against the items of an instance: a .c file that defines what is listed here,
 * then includes this header (split_records.c, split_lattice.c). No call goes by a
 * pointer. Without an instance the header is empty.
 *
 *   items_split                        the name of its splitter, see the end of this file
 *   item_list, item_box,               what is split, lo[3] and hi[3],
 *   item_coordinate                    a coordinate of these
 *   item_bin, item_bins, items_bins()  scratch: a bin's box and count; bin[3][],
 *                                      right_box[], right_count[]
 *   item_box_empty(), item_box_add()   the union of boxes
 *   item_box_at(), item_centre2_at()   of item i: its box, twice its centre on an axis
 *   items_swap()                       items i and k change their positions
 *   item_axis, item_axis_of(),         how centres become bins on an axis: from their
 *   item_bin_of()                      bounds; the bin of a centre, 0 .. PLT_SAH_BINS - 1
 *   items_cost()                       of two sides, their boxes and counts
 *   ITEMS_SWEEP_FEW                    1: ranges of no more items than bins are sorted, and
 *                                      every split of them has its cost; needs item_index(),
 *                                      item_set_index() and few_*[] in the scratch
 *   ITEMS_SELECT_HALVES                1: quickselect before a range is halved by count
 *
 * Three ways to split. Surface area heuristic: items are counted into bins by their
 * centres, on all three axes in one pass; the cheapest of the 3 * (bins - 1) planes
 * wins, the first of equals. Spatial median, the thesis's: the longest axis of the
 * tight box, an item goes left when its centre lies below the middle. Halves by
 * count along that axis: when the depth runs out or no plane separates anything.
 *
 * Sources: Wald, "On fast construction of SAH-based bounding volume hierarchies",
 * 2007; Karrenberg 2007, sections 2.2, 5.1 (the BVH that the BPH is made from), 6.4.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BUILDER_SPLIT_ITEMS_H
#define PLT_BUILDER_SPLIT_ITEMS_H

#ifdef items_split

#include <stddef.h>

#include "engine/builder/split.h"
#include "engine/planelet.h"

typedef struct split_candidate {
    float cost;
    int axis;      /* -1: none */
    uint32_t bin;  /* first bin of the right side */
    uint32_t left; /* items of the left side */
    item_box child[2];
} split_candidate;

static split_candidate split_none(void) {
    const split_candidate none = {0.0f, -1, 0, 0, {{{0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}}};
    return none;
}

static item_box split_box_of(const item_list *items, uint32_t begin, uint32_t end) {
    item_box all = item_box_empty();
    for (uint32_t i = begin; i < end; i++) {
        const item_box b = item_box_at(items, i);
        item_box_add(&all, &b);
    }
    return all;
}

static int split_longest_axis(const item_box *b) {
    int axis = 0;
    for (int a = 1; a < 3; a++) {
        axis = b->hi[a] - b->lo[a] > b->hi[axis] - b->lo[axis] ? a : axis;
    }
    return axis;
}

/* Where an item's centre decides over its side: its bin, or the coordinate. */
typedef struct split_plane {
    int axis;
    const item_axis *bins;   /* NULL: no bins */
    uint32_t bin;            /* first of the right side */
    item_coordinate middle2; /* twice the coordinate, which belongs to the right side */
} split_plane;

/* Returns the first item of the right side. */
static uint32_t split_partition(item_list *items, uint32_t begin, uint32_t end,
                                const split_plane *plane) {
    while (begin < end) {
        const item_coordinate centre2 = item_centre2_at(items, begin, plane->axis);
        if (plane->bins != NULL ? item_bin_of(plane->bins, centre2) < plane->bin
                                : centre2 < plane->middle2) {
            begin++;
        } else {
            items_swap(items, begin, --end);
        }
    }
    return begin;
}

/* ---- the surface area heuristic ---- */

static void split_lay_out_bins(const item_list *items, uint32_t begin, uint32_t end,
                               item_axis axis[3]) {
    item_box centres2 = item_box_empty();
    for (uint32_t i = begin; i < end; i++) {
        const item_box b = item_box_at(items, i);
        const item_coordinate x = b.lo[0] + b.hi[0], y = b.lo[1] + b.hi[1], z = b.lo[2] + b.hi[2];
        const item_box point = {{x, y, z}, {x, y, z}};
        item_box_add(&centres2, &point);
    }
    for (int a = 0; a < 3; a++) {
        axis[a] = item_axis_of(centres2.lo[a], centres2.hi[a]);
    }
}

static void split_fill_bins(item_list *items, uint32_t begin, uint32_t end,
                            const item_axis axis[3]) {
    item_bins *bins = items_bins(items);
    const item_bin empty = {item_box_empty(), 0};
    for (int a = 0; a < 3; a++) {
        for (int k = 0; k < PLT_SAH_BINS; k++) {
            bins->bin[a][k] = empty;
        }
    }
    for (uint32_t i = begin; i < end; i++) {
        const item_box b = item_box_at(items, i);
        for (int a = 0; a < 3; a++) {
            item_bin *bin = &bins->bin[a][item_bin_of(&axis[a], b.lo[a] + b.hi[a])];
            item_box_add(&bin->box, &b);
            bin->count++;
        }
    }
}

/* Sweeps an axis from the right, then from the left, over running unions. A plane
 * behind an empty bin has the cost of the one before it. */
static void split_sweep(item_list *items, int axis, uint32_t total, split_candidate *best) {
    item_bins *bins = items_bins(items);
    const item_bin *bin = bins->bin[axis];
    item_box box = item_box_empty();
    uint32_t count = 0;
    for (uint32_t k = PLT_SAH_BINS - 1; k > 0; k--) {
        item_box_add(&box, &bin[k].box);
        count += bin[k].count;
        bins->right_box[k] = box;
        bins->right_count[k] = count;
    }
    box = item_box_empty();
    count = 0;
    for (uint32_t k = 1; k < PLT_SAH_BINS; k++) {
        item_box_add(&box, &bin[k - 1].box);
        count += bin[k - 1].count;
        if (count == 0 || count == total || bin[k - 1].count == 0) {
            continue;
        }
        const float cost =
            items_cost(items, &box, count, &bins->right_box[k], bins->right_count[k]);
        if (best->axis < 0 || cost < best->cost) {
            const split_candidate better = {cost, axis, k, count, {box, bins->right_box[k]}};
            *best = better;
        }
    }
}

/* Returns the middle, `begin` when no plane separates anything. */
static uint32_t split_sah(item_list *items, uint32_t begin, uint32_t end, item_box child[2]) {
    item_axis axis[3];
    split_lay_out_bins(items, begin, end, axis);
    split_fill_bins(items, begin, end, axis);
    split_candidate best = split_none();
    for (int a = 0; a < 3; a++) {
        split_sweep(items, a, end - begin, &best);
    }
    if (best.axis < 0) {
        return begin;
    }
    const uint32_t middle = begin + best.left;
    const split_plane plane = {best.axis, &axis[best.axis], best.bin, 0};
    split_partition(items, begin, end, &plane);
    child[0] = best.child[0];
    child[1] = best.child[1];
    return middle;
}

#if ITEMS_SWEEP_FEW
/* Ranks of the range's items along an axis, by insertion; of equals the first. Each
 * becomes a bin of its own. */
static void split_rank_few(item_bins *bins, int axis, uint32_t count) {
    uint8_t *rank = bins->few_rank[axis];
    const item_box *box = bins->few_box;
    for (uint32_t i = 0; i < count; i++) {
        uint32_t k = i;
        const item_coordinate c = box[i].lo[axis] + box[i].hi[axis];
        for (; k > 0 && box[rank[k - 1]].lo[axis] + box[rank[k - 1]].hi[axis] > c; k--) {
            rank[k] = rank[k - 1];
        }
        rank[k] = (uint8_t)i;
    }
    for (uint32_t k = 0; k < PLT_SAH_BINS; k++) {
        bins->bin[axis][k].count = k < count;
        bins->bin[axis][k].box = k < count ? box[rank[k]] : item_box_empty();
    }
}

/* At most as many items as bins: every split in order along an axis gets its cost. */
static uint32_t split_few(item_list *items, uint32_t begin, uint32_t count, item_box child[2]) {
    item_bins *bins = items_bins(items);
    split_candidate best = split_none();
    for (uint32_t i = 0; i < count; i++) {
        bins->few_index[i] = item_index(items, begin + i);
        bins->few_box[i] = item_box_of(items, bins->few_index[i]);
    }
    for (int a = 0; a < 3; a++) {
        split_rank_few(bins, a, count);
        split_sweep(items, a, count, &best);
    }
    for (uint32_t i = 0; i < count; i++) {
        item_set_index(items, begin + i, bins->few_index[bins->few_rank[best.axis][i]]);
    }
    child[0] = best.child[0];
    child[1] = best.child[1];
    return begin + best.left;
}
#endif

/* ---- the spatial median ---- */

static uint32_t split_median(item_list *items, uint32_t begin, uint32_t end, const item_box *box) {
    const int axis = split_longest_axis(box);
    const split_plane plane = {axis, NULL, 0, box->lo[axis] + box->hi[axis]};
    return split_partition(items, begin, end, &plane);
}

/* ---- halves by count ---- */

#if ITEMS_SELECT_HALVES
/* One round of quickselect over [begin, end): returns where those equal to the pivot
 * begin, after everything below it; `*above` is where those greater begin. */
static uint32_t split_three(item_list *items, uint32_t begin, uint32_t end, int axis,
                            uint32_t *above) {
    const item_coordinate pivot = item_centre2_at(items, begin + (end - begin) / 2, axis);
    uint32_t below = begin, at = begin;
    while (at < end) {
        const item_coordinate centre2 = item_centre2_at(items, at, axis);
        if (centre2 < pivot) {
            items_swap(items, at++, below++);
        } else if (centre2 > pivot) {
            items_swap(items, at, --end);
        } else {
            at++;
        }
    }
    *above = end;
    return below;
}

/* An order made to be slow stops being sorted after 64 rounds: halves they are all
 * the same. */
static void split_select(item_list *items, uint32_t begin, uint32_t end, uint32_t middle,
                         int axis) {
    for (int round = 0; end - begin > 1 && round < 64; round++) {
        uint32_t above;
        const uint32_t below = split_three(items, begin, end, axis, &above);
        if (middle < below) {
            end = below;
        } else if (middle >= above) {
            begin = above;
        } else {
            break;
        }
    }
}
#endif

static uint32_t split_halves(item_list *items, uint32_t begin, uint32_t end, const item_box *box) {
    const uint32_t middle = begin + (end - begin) / 2;
#if ITEMS_SELECT_HALVES
    split_select(items, begin, end, middle, split_longest_axis(box));
#else
    (void)items, (void)box;
#endif
    return middle;
}

/* ---- the choice ---- */

/* Splits as the range asks; the middle, or `begin` or `end` when that separates nothing. */
static uint32_t split_as_asked(item_list *items, const plt_split_range *range, const item_box *box,
                               item_box child[2]) {
    if (range->splits == PLT_SPLIT_MEDIAN) {
        return split_median(items, range->begin, range->end, box);
    }
#if ITEMS_SWEEP_FEW
    if (range->end - range->begin <= PLT_SAH_BINS) {
        return split_few(items, range->begin, range->end - range->begin, child);
    }
#endif
    return split_sah(items, range->begin, range->end, child);
}

/* Permutes the items of a range, whose tight box is `box`; returns the first of the
 * right child, neither being empty, and both children's tight boxes. A range that
 * could not be finished by halving in the levels left after one more free split is
 * halved by count. */
uint32_t items_split(item_list *items, const plt_split_range *range, const item_box *box,
                     item_box child[2]) {
    const uint32_t begin = range->begin, end = range->end;
    const uint32_t levels = plt_levels_needed(end - begin, range->leaf_triangles);
    uint32_t middle = begin;
    int has_boxes = 0;
    if (levels + range->depth < PLT_DEPTH_MAX) {
        middle = split_as_asked(items, range, box, child);
        has_boxes = range->splits == PLT_SPLIT_SAH;
    }
    if (middle == begin || middle == end) {
        middle = split_halves(items, begin, end, box);
        has_boxes = 0;
    }
    if (!has_boxes) {
        child[0] = split_box_of(items, begin, middle);
        child[1] = split_box_of(items, middle, end);
    }
    return middle;
}

#endif
#endif
