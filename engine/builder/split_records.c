/* split_records - float records as items: the splitter of the thesis tree
 *
 * The thesis's cost counts triangles: half the area of a box * its triangles.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/builder/split.h"

#define items_split plt_split_records
#define ITEMS_FEW (PLT_SAH_BINS < 16 ? PLT_SAH_BINS : 16)
#define ITEMS_SELECT_HALVES 1 /* halves are sorted along the longest axis */

typedef plt_record_items item_list;
typedef plt_box item_box;
typedef float item_coordinate;

static plt_split_bins *items_bins(item_list *items) {
    return items->bins;
}

/* Records lie in a row: the processor sees that. */
static inline void item_prefetch(const item_list *items, uint32_t i) {
    (void)items, (void)i;
}

#if PLT_LANES_REGISTERS
/* A corner and the word behind it. */
static inline f4 record_corner(const plt_record *r, int corner) {
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    return f4_load((const float *)(const void *)&r->word[3 * corner]);
#else
    const float at[4] = {plt_record_float(r, corner, 0), plt_record_float(r, corner, 1),
                         plt_record_float(r, corner, 2), 0.0f};
    return f4_load(at);
#endif
}

static inline plt_split_box item_box_at(const item_list *items, uint32_t i) {
    const plt_record *r = &items->records[i];
    const f4 p = record_corner(r, 0), q = record_corner(r, 1), s = record_corner(r, 2);
    const plt_split_box b = {f4_min(s, f4_min(p, q)), f4_max(s, f4_max(p, q))};
    return b;
}

static plt_box item_box_from(const plt_split_box *b) {
    float lo[4], hi[4];
    plt_box box;
    f4_store(lo, b->lo);
    f4_store(hi, b->hi);
    memcpy(box.lo, lo, sizeof box.lo);
    memcpy(box.hi, hi, sizeof box.hi);
    return box;
}

typedef f4 item_number;
#else
static PLT_SPLIT_APART plt_split_box item_box_at(const item_list *items, uint32_t i) {
    return plt_record_box(&items->records[i]);
}

static inline plt_box item_box_from(const plt_split_box *b) {
    return *b;
}

typedef float item_number;
#endif

/* Exact to one rounding. */
static PLT_SPLIT_APART float item_centre2_at(const item_list *items, uint32_t i, int axis) {
    const plt_record *r = &items->records[i];
    const float p = plt_record_float(r, 0, axis), q = plt_record_float(r, 1, axis),
                s = plt_record_float(r, 2, axis);
    const float lo = p < q ? p : q, hi = p > q ? p : q;
    return (s < lo ? s : lo) + (s > hi ? s : hi);
}

static PLT_SPLIT_APART void items_swap(item_list *items, uint32_t i, uint32_t k) {
    const plt_record t = items->records[i];
    items->records[i] = items->records[k];
    items->records[k] = t;
}

static inline float item_place_at(const item_list *items, uint32_t i, int axis) {
    return item_centre2_at(items, i, axis);
}

static inline item_number item_weight(const item_list *items, item_number count) {
    (void)items;
    return count;
}

static inline item_number item_penalty(const item_list *items, item_number cost,
                                       item_number left_count, uint32_t total) {
    (void)items, (void)left_count, (void)total;
    return cost;
}

#if PLT_WITH_REBUILD
#define items_split_begin plt_split_records_begin
#define items_split_some plt_split_records_some
#endif
#if PLT_WITH_SUBTREES
#define items_split_at plt_split_records_at
#endif

/* The splitter itself. */
#include "engine/builder/split_items.h"
