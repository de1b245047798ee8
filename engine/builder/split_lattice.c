/* split_lattice - lattice triangles as items: the splitter of compact blocks
 *
 * What moves is an index of the permutation, not the triangle. The cost counts
 * lists instead of triangles: that fills them (fewer nodes, and pairs where they
 * are free), and near the leaves prefers splits that need no leaf more.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/builder/blocks_state.h"

#define items_split plt_split_lattice
#define ITEMS_FEW PLT_SAH_BINS
#define ITEMS_SELECT_HALVES 0 /* halves are what the permutation has there */

/* Cost of a split whose sides need one leaf more than the whole: it is a node,
 * whose bytes are worth a split that is at most a 32nd worse. */
#define LEAF_PENALTY 1.03125f

typedef plt_blocks_state item_list;
typedef plt_lattice_box item_box;
typedef uint32_t item_coordinate;

static plt_split_bins *items_bins(item_list *items) {
    return &items->bins;
}

/* Lattice coordinates have at most 21 bits: floats hold them, and their sums, exactly. The mask
 * is for a source that is read again and has changed: it may give anything. */
#define COORDINATE_MOST ((1u << PLT_LATTICE_BITS_MOST) - 1u)

static plt_lattice_box lattice_box_at(const item_list *items, uint32_t i) {
    return plt_lattice_triangle_box(&items->job->triangles, plt_permuted(items, i));
}

#if PLT_LANES_REGISTERS
/* Whether the corners of a triangle are read as eight bytes each, two too many: not those of the
 * last one, nor through a cache, whose lines end somewhere. */
static inline int is_read_at_once(const plt_lattice_triangles *t, uint32_t triangle) {
    return t->width == 2 && !t->boxes && t->cache == NULL && triangle + 1 < t->count;
}

static inline void item_prefetch(const item_list *items, uint32_t i) {
    const plt_lattice_triangles *t = &items->job->triangles;
    if (is_read_at_once(t, 0)) {
        plt_prefetch(t->bytes + (size_t)18 * plt_permuted(items, i));
    }
}

static inline plt_split_box item_box_at(const item_list *items, uint32_t i) {
    const plt_lattice_triangles *t = &items->job->triangles;
    const uint32_t triangle = plt_permuted(items, i);
    if (is_read_at_once(t, triangle)) {
        const unsigned char *at = t->bytes + (size_t)18 * triangle;
        const f4 p = f4_of_halves(at), q = f4_of_halves(at + 6), s = f4_of_halves(at + 12);
        const plt_split_box box = {f4_min(s, f4_min(p, q)), f4_max(s, f4_max(p, q))};
        return box;
    }
    const plt_lattice_box b = lattice_box_at(items, i);
    const u4 most = u4_all(COORDINATE_MOST);
    const plt_split_box box = {f4_of_u4(u4_and(u4_three(b.lo[0], b.lo[1], b.lo[2]), most)),
                               f4_of_u4(u4_and(u4_three(b.hi[0], b.hi[1], b.hi[2]), most))};
    return box;
}
#else
static inline void item_prefetch(const item_list *items, uint32_t i) {
    (void)items, (void)i;
}

static PLT_SPLIT_APART plt_split_box item_box_at(const item_list *items, uint32_t i) {
    const plt_lattice_box b = lattice_box_at(items, i);
    plt_split_box box;
    for (int a = 0; a < 3; a++) {
        box.lo[a] = (float)(int32_t)(b.lo[a] & COORDINATE_MOST);
        box.hi[a] = (float)(int32_t)(b.hi[a] & COORDINATE_MOST);
    }
    return box;
}
#endif

static plt_lattice_box item_box_from(const plt_split_box *b) {
    float lo[4], hi[4];
    plt_lattice_box box;
#if PLT_LANES_REGISTERS
    f4_store(lo, b->lo);
    f4_store(hi, b->hi);
#else
    memcpy(lo, b->lo, sizeof b->lo);
    memcpy(hi, b->hi, sizeof b->hi);
#endif
    for (int a = 0; a < 3; a++) {
        box.lo[a] = (uint32_t)(int32_t)lo[a];
        box.hi[a] = (uint32_t)(int32_t)hi[a];
    }
    return box;
}

static PLT_SPLIT_APART uint32_t item_centre2_at(const item_list *items, uint32_t i, int axis) {
    return plt_lattice_triangle_centre2(&items->job->triangles, plt_permuted(items, i),
                                        (uint32_t)axis);
}

static inline float item_place_at(const item_list *items, uint32_t i, int axis) {
    return (float)(int32_t)item_centre2_at(items, i, axis);
}

static PLT_SPLIT_APART void items_swap(item_list *items, uint32_t i, uint32_t k) {
    const uint32_t t = plt_permuted(items, i);
    plt_permute(items, i, plt_permuted(items, k));
    plt_permute(items, k, t);
}

/* Full lists, or leaves, of `each` (a power of two) items that `count` take: the quotient
 * rounded up. 2^23 added leaves no fraction; what is below it and not 0 is at least 1 / each. */
#define WHOLE 8388608.0f

#if PLT_LANES_REGISTERS
static inline f4 lists_of(f4 count, uint32_t each) {
    const float share = 1.0f / (float)(int32_t)each;
    const f4 up = f4_all(0.5f - 0.5f * share), whole = f4_all(WHOLE);
    return f4_sub(f4_add(f4_add(f4_mul(count, f4_all(share)), up), whole), whole);
}

static inline f4 item_weight(const item_list *items, f4 count) {
    return lists_of(count, items->job->leaf_triangles);
}

/* The leaf penalty counts only where counts are exact; higher up what is left over is shared
 * out further down. */
static inline f4 item_penalty(const item_list *items, f4 cost, f4 left_count, uint32_t total) {
    if (total > PLT_SAH_BINS) {
        return cost;
    }
    const uint32_t leaf = 2 * items->job->leaf_triangles;
    const f4 all = f4_all((float)(int32_t)total);
    const f4 leaves = f4_add(lists_of(left_count, leaf), lists_of(f4_sub(all, left_count), leaf));
    const m4 spills = f4_lt(lists_of(all, leaf), leaves);
    return f4_select(spills, f4_mul(cost, f4_all(LEAF_PENALTY)), cost);
}
#else
static float lists_of(float count, uint32_t each) {
    const float share = 1.0f / (float)(int32_t)each, up = 0.5f - 0.5f * share;
    const float part = count * share;
    const float sum = part + up;
    const float whole = sum + WHOLE;
    return whole - WHOLE;
}

static inline float item_weight(const item_list *items, float count) {
    return lists_of(count, items->job->leaf_triangles);
}

static float item_penalty(const item_list *items, float cost, float left_count, uint32_t total) {
    const uint32_t leaf = 2 * items->job->leaf_triangles;
    const float all = (float)(int32_t)total;
    const float leaves = lists_of(left_count, leaf) + lists_of(all - left_count, leaf);
    return total <= PLT_SAH_BINS && lists_of(all, leaf) < leaves ? cost * LEAF_PENALTY : cost;
}
#endif

/* The splitter itself. */
#include "engine/builder/split_items.h"
