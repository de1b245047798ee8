/* split_records - float records as items: the splitter of the thesis tree
 *
 * The thesis's cost counts triangles: half the area of a box * its triangles.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/builder/split.h"

#define items_split plt_split_records
#define ITEMS_SWEEP_FEW 0     /* bins for small ranges, too */
#define ITEMS_SELECT_HALVES 1 /* halves are sorted along the longest axis */

typedef plt_record_items item_list;
typedef plt_record_bin item_bin;
typedef plt_record_bins item_bins;
typedef plt_box item_box;
typedef float item_coordinate;

/* bin = (centre2 - lo) * scale. */
typedef struct item_axis {
    float lo, scale;
} item_axis;

static item_bins *items_bins(item_list *items) {
    return items->bins;
}

static plt_box item_box_empty(void) {
    return plt_box_empty();
}

static void item_box_add(plt_box *box, const plt_box *more) {
    plt_box_add(box, more);
}

static plt_box item_box_at(const item_list *items, uint32_t i) {
    return plt_record_box(&items->records[i]);
}

/* Exact to one rounding. */
static inline float item_centre2_at(const item_list *items, uint32_t i, int axis) {
    const plt_record *r = &items->records[i];
    const float p = plt_record_float(r, 0, axis), q = plt_record_float(r, 1, axis),
                s = plt_record_float(r, 2, axis);
    const float lo = p < q ? p : q, hi = p > q ? p : q;
    return (s < lo ? s : lo) + (s > hi ? s : hi);
}

static inline void items_swap(item_list *items, uint32_t i, uint32_t k) {
    const plt_record t = items->records[i];
    items->records[i] = items->records[k];
    items->records[k] = t;
}

/* All in bin 0 where the extent is 0, or so small that the scale would overflow. */
static item_axis item_axis_of(float lo, float hi) {
    const float extent = hi - lo, scale = (float)PLT_SAH_BINS / extent;
    const item_axis axis = {lo, extent > 0.0f && scale < PLT_BOX_FAR ? scale : 0.0f};
    return axis;
}

static uint32_t item_bin_of(const item_axis *axis, float centre2) {
    const int bin = (int)((centre2 - axis->lo) * axis->scale);
    return bin < PLT_SAH_BINS ? (uint32_t)bin : PLT_SAH_BINS - 1;
}

static float items_cost(const item_list *items, const plt_box *left, uint32_t left_count,
                        const plt_box *right, uint32_t right_count) {
    (void)items;
    return plt_box_half_area(left) * (float)left_count +
           plt_box_half_area(right) * (float)right_count;
}

/* The splitter itself. */
#include "engine/builder/split_items.h"
