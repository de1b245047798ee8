/* split_lattice - lattice triangles as items: the splitter of compact blocks
 *
 * What moves is an index of the permutation, not the triangle. The cost counts
 * lists instead of triangles: that fills them (fewer nodes, and pairs where they
 * are free), and near the leaves prefers splits that need no leaf more.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/builder/blocks_state.h"

#define items_split plt_split_lattice
#define ITEMS_SWEEP_FEW 1     /* every split of a range of no more triangles than bins */
#define ITEMS_SELECT_HALVES 0 /* halves are what the permutation has there */

/* Cost of a split whose sides need one leaf more than the whole: it is a node,
 * whose bytes are worth a split that is at most a 32nd worse. */
#define LEAF_PENALTY 1.03125f

typedef plt_blocks_state item_list;
typedef plt_lattice_bin item_bin;
typedef plt_lattice_bins item_bins;
typedef plt_lattice_box item_box;
typedef uint32_t item_coordinate;

/* bin = (centre2 - lo) * PLT_SAH_BINS / span; span: the extent + 1. */
typedef struct item_axis {
    uint32_t lo, span;
} item_axis;

static item_bins *items_bins(item_list *items) {
    return &items->bins;
}

static plt_lattice_box item_box_empty(void) {
    return plt_lattice_box_empty();
}

static void item_box_add(plt_lattice_box *box, const plt_lattice_box *more) {
    plt_lattice_box_add(box, more);
}

static uint32_t item_index(const item_list *items, uint32_t i) {
    return plt_permuted(items, i);
}

static void item_set_index(item_list *items, uint32_t i, uint32_t index) {
    plt_permute(items, i, index);
}

static plt_lattice_box item_box_of(const item_list *items, uint32_t index) {
    return plt_lattice_triangle_box(&items->job->triangles, index);
}

static plt_lattice_box item_box_at(const item_list *items, uint32_t i) {
    return item_box_of(items, item_index(items, i));
}

static uint32_t item_centre2_at(const item_list *items, uint32_t i, int axis) {
    const plt_lattice_box b = item_box_at(items, i);
    return b.lo[axis] + b.hi[axis];
}

static void items_swap(item_list *items, uint32_t i, uint32_t k) {
    const uint32_t t = plt_permuted(items, i);
    plt_permute(items, i, plt_permuted(items, k));
    plt_permute(items, k, t);
}

static item_axis item_axis_of(uint32_t lo, uint32_t hi) {
    const item_axis axis = {lo, hi - lo + 1};
    return axis;
}

/* Within the bins also for a centre that has changed since they were laid out, as a
 * source that is read again may have it. */
static uint32_t item_bin_of(const item_axis *axis, uint32_t centre2) {
    const uint32_t bin = (centre2 - axis->lo) * PLT_SAH_BINS / axis->span;
    return bin < PLT_SAH_BINS ? bin : PLT_SAH_BINS - 1;
}

static float lattice_half_area(const plt_lattice_box *b) {
    const float x = (float)(int32_t)(b->hi[0] - b->lo[0]);
    const float y = (float)(int32_t)(b->hi[1] - b->lo[1]);
    const float z = (float)(int32_t)(b->hi[2] - b->lo[2]);
    return x * y + y * z + z * x;
}

/* Full lists, or leaves, of `each` triangles that `count` take; the last may hold fewer. */
static uint32_t lists_of(uint32_t count, uint32_t each) {
    return (count + each - 1) / each;
}

/* Half the area of a box * its lists, of both sides. The leaf penalty counts only
 * where counts are exact; higher up what is left over is shared out further down. */
static float items_cost(const item_list *items, const plt_lattice_box *left, uint32_t left_count,
                        const plt_lattice_box *right, uint32_t right_count) {
    const uint32_t k = items->job->leaf_triangles, total = left_count + right_count;
    const float cost = lattice_half_area(left) * (float)(int32_t)lists_of(left_count, k) +
                       lattice_half_area(right) * (float)(int32_t)lists_of(right_count, k);
    const int spills =
        lists_of(left_count, 2 * k) + lists_of(right_count, 2 * k) > lists_of(total, 2 * k);
    return spills && total <= PLT_SAH_BINS ? cost * LEAF_PENALTY : cost;
}

/* The splitter itself. */
#include "engine/builder/split_items.h"
