/* split_items - the splitting heuristics, once for whatever can be split
 *
 * Written against the items of an instance: a .c file that defines what is listed here,
 * then includes this header (split_records.c, split_lattice.c). No call goes by a
 * pointer. Without an instance the header is empty.
 *
 *   items_split                        the name of its splitter, see the end of this file
 *   item_list, item_box,               what is split, lo[3] and hi[3],
 *   item_coordinate                    a coordinate of these
 *   items_bins()                       scratch: plt_split_bins
 *   item_box_at()                      of item i: its box as a plt_split_box, exact
 *   item_box_from()                      a box in lanes as an item_box
 *   item_centre2_at()                  of item i: twice its centre on an axis, exact
 *   item_place_at()                    the same as a float
 *   item_prefetch()                    item i is looked at soon
 *   items_swap()                       items i and k change their positions
 *   item_weight(), item_penalty()      what `count` items cost, four numbers at once; what a
 *                                      split costs beyond its sides
 *   ITEMS_FEW                          ranges of no more items are sorted, and every split of
 *                                      them has its cost; at most PLT_SAH_BINS
 *   ITEMS_SELECT_HALVES                1: quickselect before a range is halved by count
 *   items_split_begin, ..._some        if defined: in steps, too (split_steps.h)
 *   items_split_at                     if defined: a split by count, wherever it is asked for
 *
 * Three ways to split. Surface area heuristic: items are counted into bins by their
 * centres, on all three axes in one pass; the cheapest of the 3 * (bins - 1) planes
 * wins, the first of equals (split_sweep.h). Of a few items each has a bin of its own, in
 * the order of centres. Spatial median, the thesis's: the longest axis of the
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
#include "engine/builder/split_bins.h"
#include "engine/builder/split_sweep.h"
#include "engine/lanes/unroll.h"
#include "engine/planelet.h"

static item_box split_box_of(const item_list *items, uint32_t begin, uint32_t end) {
    plt_split_box all = plt_split_box_empty();
    for (uint32_t i = begin; i < end; i++) {
        const plt_split_box b = item_box_at(items, i);
        plt_split_box_add(&all, &b);
    }
    return item_box_from(&all);
}

static int split_longest_axis(const item_box *b) {
    int axis = 0;
    for (int a = 1; a < 3; a++) {
        axis = b->hi[a] - b->lo[a] > b->hi[axis] - b->lo[axis] ? a : axis;
    }
    return axis;
}

/* ---- the surface area heuristic ---- */

enum { SPLIT_AHEAD = 16 }; /* items that are fetched before they are looked at */

typedef plt_split_grid split_grid;

#if PLT_LANES_REGISTERS
static inline plt_split_box split_point(const plt_split_box *b) {
    const f4 at = f4_add(b->lo, b->hi);
    const plt_split_box point = {at, at};
    return point;
}

static inline void split_store(const plt_split_box *b, float lo[4], float hi[4]) {
    f4_store(lo, b->lo);
    f4_store(hi, b->hi);
}

/* The bins of a box, as numbers that are not whole yet. */
static inline void split_places(const split_grid *grid, const plt_split_box *b, float place[4]) {
    const f4 last = f4_all((float)(int32_t)(grid->bins - 1));
    const f4 offset = f4_sub(f4_add(b->lo, b->hi), f4_load(grid->lo));
    const f4 at = f4_mul(offset, f4_load(grid->scale));
    f4_store(place, f4_max(f4_min(at, last), f4_zero()));
}
#else
static plt_split_box split_point(const plt_split_box *b) {
    plt_split_box point;
    for (int a = 0; a < 3; a++) {
        point.lo[a] = point.hi[a] = b->lo[a] + b->hi[a];
    }
    return point;
}

static void split_store(const plt_split_box *b, float lo[4], float hi[4]) {
    memcpy(lo, b->lo, sizeof b->lo);
    memcpy(hi, b->hi, sizeof b->hi);
}

static void split_places(const split_grid *grid, const plt_split_box *b, float place[4]) {
    const float last = (float)(int32_t)(grid->bins - 1);
    for (int a = 0; a < 3; a++) {
        const float centre2 = b->lo[a] + b->hi[a];
        const float offset = centre2 - grid->lo[a];
        const float at = offset * grid->scale[a], most = at < last ? at : last;
        place[a] = most > 0.0f ? most : 0.0f;
    }
}
#endif

/* All in bin 0 where the extent is 0, or so small that the scale would overflow. */
static float split_scale(float extent, uint32_t bins) {
    const float scale = (float)(int32_t)bins / extent;
    return extent > 0.0f && scale < PLT_BOX_FAR ? scale : 0.0f;
}

/* A sweep over a bin costs about as much as an item: few items get few bins. */
static uint32_t split_bin_count(uint32_t count) {
    return count <= 256 && PLT_SAH_BINS > 16 ? 16 : PLT_SAH_BINS;
}

/* From every `step`-th item: others may lie outside, they count in the first or the last bin. */
static void split_add_points(const item_list *items, uint32_t begin, uint32_t end, uint32_t step,
                             plt_split_box *all) {
    for (uint32_t i = begin; i < end; i += step) {
        const plt_split_box b = item_box_at(items, i);
        const plt_split_box point = split_point(&b);
        plt_split_box_add(all, &point);
    }
}

static split_grid split_grid_of(const plt_split_box *points, uint32_t count) {
    split_grid grid = {{0, 0, 0, 0}, {0, 0, 0, 0}, split_bin_count(count)};
    float hi[4];
    split_store(points, grid.lo, hi);
    for (int a = 0; a < 3; a++) {
        grid.scale[a] = split_scale(hi[a] - grid.lo[a], grid.bins);
    }
    return grid;
}

static void split_set_count(plt_split_bins *bins, uint32_t k, uint32_t count) {
    for (int a = 0; a < 3; a++) {
        bins->count[k][a] = count;
    }
}

static void split_empty_bins(plt_split_bins *bins, uint32_t count) {
    const plt_split_box empty = plt_split_box_empty();
    for (uint32_t k = 0; k < count; k++) {
        for (int a = 0; a < 3; a++) {
            plt_split_set_row(bins, a, k, &empty);
        }
        split_set_count(bins, k, 0);
    }
}

static void split_fill_bins(item_list *items, uint32_t begin, uint32_t end,
                            const split_grid *grid) {
    plt_split_bins *bins = items_bins(items);
    for (uint32_t i = begin; i < end; i++) {
        item_prefetch(items, i + SPLIT_AHEAD < end ? i + SPLIT_AHEAD : begin);
        const plt_split_box b = item_box_at(items, i);
        float place[4];
        split_places(grid, &b, place);
        for (int a = 0; a < 3; a++) {
            const uint32_t k = (uint32_t)(int32_t)place[a];
            plt_split_box row = plt_split_row(bins, a, k);
            plt_split_box_add(&row, &b);
            plt_split_set_row(bins, a, k, &row);
            bins->count[k][a]++;
        }
    }
}

static item_box split_rows_box(const plt_split_bins *bins, int axis, uint32_t begin, uint32_t end) {
    plt_split_box all = plt_split_box_empty();
    for (uint32_t k = begin; k < end; k++) {
        const plt_split_box row = plt_split_row(bins, axis, k);
        plt_split_box_add(&all, &row);
    }
    return item_box_from(&all);
}

typedef plt_split_plane split_plane;
typedef plt_split_wrong split_wrong;
typedef plt_split_sides split_sides_found;

/* Each step is rounded to a float, as in lanes: so the sides are those of split_fill_bins. */
static inline uint32_t split_is_right(const item_list *items, uint32_t i, const split_plane *p) {
    const float place = item_place_at(items, i, p->axis);
    const float offset = place - p->lo;
    const float bin = offset * p->scale;
    return bin >= p->row;
}

/* Looks at a block from `at` on, upwards for those on the right, or downwards for the others. */
static void split_find_wrong(const item_list *items, uint32_t at, uint32_t downwards,
                             const split_plane *plane, split_wrong *w) {
    const uint32_t step = downwards ? (uint32_t)-1 : 1;
    w->next = w->count = 0;
    for (uint32_t i = 0; i < PLT_SPLIT_BLOCK; i++, at += step) {
        item_prefetch(items, at + PLT_SPLIT_BLOCK * step);
        w->at[w->count] = (uint8_t)i;
        w->count += split_is_right(items, at, plane) ^ downwards;
    }
}

/* By blocks, until there are at most `left` items, or fewer than two blocks. */
PLT_INLINED void split_partition_blocks(item_list *items, split_sides_found *s,
                                        const split_plane *plane, uint32_t left) {
    while (s->end - s->begin >= 2 * PLT_SPLIT_BLOCK && (left == 0 || s->end - s->begin > left)) {
        if (s->left.next == s->left.count) {
            split_find_wrong(items, s->begin, 0, plane, &s->left);
        }
        if (s->right.next == s->right.count) {
            split_find_wrong(items, s->end - 1, 1, plane, &s->right);
        }
        while (s->left.next < s->left.count && s->right.next < s->right.count) {
            items_swap(items, s->begin + s->left.at[s->left.next++],
                       s->end - 1 - s->right.at[s->right.next++]);
        }
        s->begin += s->left.next == s->left.count ? PLT_SPLIT_BLOCK : 0;
        s->end -= s->right.next == s->right.count ? PLT_SPLIT_BLOCK : 0;
    }
}

/* The rest one by one; returns the first item of the right side. */
static uint32_t split_partition_rest(item_list *items, uint32_t begin, uint32_t end,
                                     const split_plane *plane) {
    while (begin < end) {
        if (split_is_right(items, begin, plane)) {
            items_swap(items, begin, --end);
        } else {
            begin++;
        }
    }
    return begin;
}

/* Returns the first item of the right side.
 * Source: Edelkamp, Weiss, "BlockQuicksort", 2016. */
static uint32_t split_partition(item_list *items, uint32_t begin, uint32_t end,
                                const split_plane *plane) {
    split_sides_found s = {.begin = begin, .end = end};
    split_partition_blocks(items, &s, plane, 0);
    return split_partition_rest(items, s.begin, s.end, plane);
}

/* Some 1,024 items of a large range say where its bins are; all are counted. */
static uint32_t split_sample_step(uint32_t count) {
    return count < 2048 ? 1 : count / 1024;
}

/* The cheapest plane between bins, and both sides' boxes; 0: no plane separates anything. */
static int split_choose(item_list *items, const split_grid *grid, uint32_t count,
                        split_plane *plane, item_box child[2]) {
    plt_split_bins *bins = items_bins(items);
    const split_choice best = split_sweep(items, bins, grid->bins, count);
    if (best.axis < 0) {
        return 0;
    }
    const split_plane chosen = {best.axis, grid->lo[best.axis], grid->scale[best.axis],
                                (float)(int32_t)best.row};
    *plane = chosen;
    child[0] = split_rows_box(bins, best.axis, 0, best.row);
    child[1] = split_rows_box(bins, best.axis, best.row, grid->bins);
    return 1;
}

/* Returns the middle, `begin` when no plane separates anything. */
static uint32_t split_sah_from(item_list *items, uint32_t begin, uint32_t end, uint32_t step,
                               item_box child[2]) {
    plt_split_bins *bins = items_bins(items);
    plt_split_box points = plt_split_box_empty();
    split_add_points(items, begin, end, step, &points);
    const split_grid grid = split_grid_of(&points, end - begin);
    split_empty_bins(bins, grid.bins);
    split_fill_bins(items, begin, end, &grid);
    split_plane plane;
    return split_choose(items, &grid, end - begin, &plane, child)
               ? split_partition(items, begin, end, &plane)
               : begin;
}

static uint32_t split_sah(item_list *items, uint32_t begin, uint32_t end, item_box child[2]) {
    const uint32_t step = split_sample_step(end - begin);
    const uint32_t middle = split_sah_from(items, begin, end, step, child);
    return middle == begin && step > 1 ? split_sah_from(items, begin, end, 1, child) : middle;
}

/* The items' ranks on three axes, of equals the first in front. */
#if PLT_LANES_REGISTERS
static void split_rank_few(const float place[][4], uint32_t count, uint8_t rank[3][ITEMS_FEW]) {
    const u4 one = u4_all(1), none = u4_all(0);
    for (uint32_t i = 0; i < count; i++) {
        const f4 mine = f4_load(place[i]);
        u4 r = none;
        for (uint32_t k = 0; k < i; k++) {
            r = u4_add(r, u4_select(f4_le(f4_load(place[k]), mine), one, none));
        }
        for (uint32_t k = i + 1; k < count; k++) {
            r = u4_add(r, u4_select(f4_lt(f4_load(place[k]), mine), one, none));
        }
        uint32_t ranks[4];
        u4_store(ranks, r);
        for (int a = 0; a < 3; a++) {
            rank[a][i] = (uint8_t)ranks[a];
        }
    }
}
#else
static void split_rank_few(const float place[][4], uint32_t count, uint8_t rank[3][ITEMS_FEW]) {
    uint8_t sorted[ITEMS_FEW];
    for (int a = 0; a < 3; a++) {
        for (uint32_t i = 0; i < count; i++) {
            uint32_t k = i;
            for (; k > 0 && place[sorted[k - 1]][a] > place[i][a]; k--) {
                sorted[k] = sorted[k - 1];
            }
            sorted[k] = (uint8_t)i;
        }
        for (uint32_t k = 0; k < count; k++) {
            rank[a][sorted[k]] = (uint8_t)k;
        }
    }
}
#endif

/* Items whose rank is below `row` to the left. */
static void split_at_rank(item_list *items, uint32_t begin, uint32_t count, uint8_t *rank,
                          uint32_t row) {
    uint32_t i = 0, k = count;
    while (i < k) {
        if (rank[i] < row) {
            i++;
        } else if (rank[k - 1] >= row) {
            k--;
        } else {
            const uint8_t r = rank[i];
            rank[i++] = rank[--k];
            rank[k] = r;
            items_swap(items, begin + i - 1, begin + k);
        }
    }
}

/* At most as many items as rows: every split in order along an axis gets its cost. */
static uint32_t split_few(item_list *items, uint32_t begin, uint32_t count, item_box child[2]) {
    plt_split_bins *bins = items_bins(items);
    uint8_t rank[3][ITEMS_FEW];
    for (uint32_t i = 0; i < count; i++) {
        const plt_split_box b = item_box_at(items, begin + i);
        plt_split_centre2(&b, bins->right_cost[i]); /* until the sweep */
    }
    split_rank_few((const float(*)[4])bins->right_cost, count, rank);
    for (uint32_t i = 0; i < count; i++) {
        const plt_split_box b = item_box_at(items, begin + i);
        for (int a = 0; a < 3; a++) {
            plt_split_set_row(bins, a, rank[a][i], &b);
        }
        split_set_count(bins, i, 1);
    }
    const split_choice best = split_sweep(items, bins, count, count);
    if (best.axis < 0) {
        return begin;
    }
    child[0] = split_rows_box(bins, best.axis, 0, best.row);
    child[1] = split_rows_box(bins, best.axis, best.row, count);
    split_at_rank(items, begin, count, rank[best.axis], best.row);
    return begin + best.row;
}

/* ---- the spatial median ---- */

static uint32_t split_median(item_list *items, uint32_t begin, uint32_t end, const item_box *box) {
    const int axis = split_longest_axis(box);
    const item_coordinate middle2 = box->lo[axis] + box->hi[axis];
    while (begin < end) {
        if (item_centre2_at(items, begin, axis) < middle2) {
            begin++;
        } else {
            items_swap(items, begin, --end);
        }
    }
    return begin;
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
    if (range->end - range->begin <= ITEMS_FEW) {
        return split_few(items, range->begin, range->end - range->begin, child);
    }
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

#include "engine/builder/split_steps.h"

#ifdef items_split_at
uint32_t items_split_at(item_list *items, uint32_t begin, uint32_t middle, uint32_t end,
                        const item_box *box, item_box child[2]) {
    split_select(items, begin, end, middle, split_longest_axis(box));
    child[0] = split_box_of(items, begin, middle);
    child[1] = split_box_of(items, middle, end);
    return middle;
}
#endif

#endif
#endif
