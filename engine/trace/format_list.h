/* format_list - no tree: all triangles are one leaf; the operations of format.h
 *
 * The reference that every tree is compared with.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_FORMAT_LIST_H
#define PLT_TRACE_FORMAT_LIST_H

#include "engine/trace/format.h"
#include "engine/trace/leaf_records.h"

enum { FORMAT_TIGHTENS = 0 };

typedef struct format_state {
    char none;
} format_state;

static inline void format_state_init(plt_traversal *t) {
    ((format_state *)t->state)->none = 0;
}

typedef struct format_place {
    char none; /* there is one leaf */
} format_place;

/* A list has none; the operations on nodes are never called. */
typedef struct format_children {
    plt_box box[2];
} format_children;

typedef struct format_room {
    char none;
} format_room;

static inline int format_root(const plt_traversal *t, format_place *place) {
    place->none = 0;
    return t->scene->list.count > 0;
}

static inline int format_is_leaf(const format_place *place) {
    (void)place;
    return 1;
}

static inline int format_is_edge(const format_place *place) {
    (void)place;
    return 0;
}

static inline const plt_box *format_box(const plt_traversal *t, const format_place *place,
                                        format_room *room) {
    (void)place;
    (void)room;
    return &t->scene->box;
}

static inline int format_enter(const plt_traversal *t, const format_place *place) {
    (void)t;
    (void)place;
    return PLT_OK;
}

static inline int format_return(const plt_traversal *t, const format_place *place) {
    (void)t;
    (void)place;
    return PLT_OK;
}

static inline void format_decode(const plt_traversal *t, const format_place *place,
                                 format_children *c) {
    (void)place;
    c->box[0] = c->box[1] = t->scene->box;
}

static inline const plt_box *format_boxes(format_children *c) {
    return c->box;
}

static inline void format_child(const format_children *c, unsigned child, format_place *place) {
    (void)c;
    (void)child;
    (void)place;
}

static inline int format_leaf(plt_traversal *t, plt_packet *p, const format_place *place,
                              plt_mask groups) {
    const plt_list *list = &t->scene->list;
    const float longest = plt_box_longest_side(&t->scene->box);
    (void)place;
    for (uint32_t i = 0; i < list->count; i++) {
        plt_record_groups(p, &list->records[i], longest, groups);
    }
    t->stats.triangle_tests += (uint64_t)list->count * plt_mask_count(groups);
    return PLT_OK;
}

#endif
