/* thesis_place - a box of a tree of thesis nodes, and how a node's children get theirs
 *
 * In two ways: for machines that hold four lanes in a register, where a box is two of them and
 * all axes are decoded at once, and for all others, float by float. Both give the same numbers.
 *
 * With PLT_TREELETS_STREAMED a place has the scope of its treelet, too; of an edge that of the one
 * behind it (memory/treelet_stream.h).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_THESIS_PLACE_H
#define PLT_TRACE_THESIS_PLACE_H

#include "engine/lanes/lanes.h"
#include "engine/trace/traversal.h"
#include "engine/tree/thesis/node.h"

#if PLT_WITH_HULLS

typedef struct format_place {
    f4 lo, hi; /* x, y, z, and a number that means nothing */
    uint32_t link;
#ifdef PLT_TREELETS_STREAMED
    uint32_t scope;
#endif
} format_place;

/* Written four lanes at once: the fourth of a store is overwritten by the next. */
typedef union format_room {
    plt_box box[2];
    float lane[13];
} format_room;

typedef struct format_children {
    const plt_node *node;
    f4 lo[2], hi[2];
    format_room room;
#ifdef PLT_TREELETS_STREAMED
    plt_treelet_stream *stream;
    uint32_t scope;
#endif
} format_children;

static inline void place_set_box(format_place *place, const plt_box *box) {
    place->lo = f4_load(box->lo);
    place->hi = f4_rotate(f4_load(&box->lo[2]));
}

static inline const plt_box *format_box(const plt_traversal *t, const format_place *place,
                                        format_room *room) {
    (void)t;
    f4_store(room->lane, place->lo);
    f4_store(room->lane + 3, place->hi);
    return room->box;
}

static inline void format_bounds(const plt_traversal *t, const format_place *place, f4 *lo,
                                 f4 *hi) {
    (void)t;
    *lo = place->lo;
    *hi = place->hi;
}

/* The six planes of a node, and no more: what lies behind them need not be a number. */
static inline void load_planes(const plt_node *node, f4 *lo, f4 *hi) {
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    float plane[6];
    for (int i = 0; i < 6; i++) {
        plane[i] = plt_get_float(&node->word[i]);
    }
#else
    const float *plane = (const float *)(const void *)node->word;
#endif
    *lo = f4_load(plane);
    *hi = f4_rotate(f4_load(plane + 2));
}

/* As plt_node_decode. */
static inline void children_decode(format_children *c, const plt_node *node,
                                   const format_place *place) {
    const u4 owner = u4_three(plt_owner_bit(0), plt_owner_bit(1), plt_owner_bit(2));
    const u4 owners_lo = u4_and(u4_all(plt_node_link(node, 0)), owner);
    const u4 owners_hi = u4_and(u4_all(plt_node_link(node, 1)), owner);
    const m4 right_lo = u4_eq(owners_lo, owner), right_hi = u4_eq(owners_hi, owner);
    c->node = node;
    load_planes(node, &c->lo[0], &c->hi[0]);
    c->lo[1] = place->lo;
    c->hi[1] = place->hi;
    f4_swap(right_lo, &c->lo[0], &c->lo[1]);
    f4_swap(right_hi, &c->hi[0], &c->hi[1]);
}

static inline const plt_box *format_boxes(format_children *c) {
    for (int i = 0; i < 2; i++) {
        f4_store(c->room.lane + 6 * i, c->lo[i]);
        f4_store(c->room.lane + 6 * i + 3, c->hi[i]);
    }
    return c->room.box;
}

static inline void format_child_bounds(const format_children *c, unsigned child, f4 *lo, f4 *hi) {
    *lo = c->lo[child];
    *hi = c->hi[child];
}

static inline void children_place(const format_children *c, unsigned child, format_place *place) {
    place->lo = c->lo[child];
    place->hi = c->hi[child];
    place->link = plt_node_link(c->node, (int)child);
}

static inline float place_longest_side(const format_place *place) {
    float side[4];
    f4_store(side, f4_sub(place->hi, place->lo));
    const float xy = side[0] > side[1] ? side[0] : side[1];
    return xy > side[2] ? xy : side[2];
}

#else

typedef struct format_place {
    plt_box box;
    uint32_t link;
#ifdef PLT_TREELETS_STREAMED
    uint32_t scope;
#endif
} format_place;

typedef struct format_room {
    char none; /* a place has its box in it */
} format_room;

typedef struct format_children {
    const plt_node *node;
    plt_box box[2];
#ifdef PLT_TREELETS_STREAMED
    plt_treelet_stream *stream;
    uint32_t scope;
#endif
} format_children;

static inline void place_set_box(format_place *place, const plt_box *box) {
    place->box = *box;
}

static inline const plt_box *format_box(const plt_traversal *t, const format_place *place,
                                        format_room *room) {
    (void)t;
    (void)room;
    return &place->box;
}

static inline void children_decode(format_children *c, const plt_node *node,
                                   const format_place *place) {
    c->node = node;
    plt_node_decode(node, &place->box, c->box);
}

static inline const plt_box *format_boxes(const format_children *c) {
    return c->box;
}

static inline void children_place(const format_children *c, unsigned child, format_place *place) {
    place->box = c->box[child];
    place->link = plt_node_link(c->node, (int)child);
}

static inline float place_longest_side(const format_place *place) {
    return plt_box_longest_side(&place->box);
}

#endif

static inline int format_is_leaf(const format_place *place) {
    return plt_link_is_leaf(place->link);
}

static inline int format_is_edge(const format_place *place) {
    return !plt_link_is_inner(place->link);
}

#endif
