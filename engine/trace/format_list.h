/* format_list - no tree: all triangles are one leaf; the operations of format.h
 *
 * The reference that every tree is compared with.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_FORMAT_LIST_H
#define PLT_TRACE_FORMAT_LIST_H

#include "engine/trace/boxes.h"
#include "engine/trace/format.h"
#include "engine/trace/leaf_records.h"

typedef struct format_entry {
    plt_mask groups;
} format_entry;

/* A list has none. */
typedef struct format_children {
    plt_box box[2];
} format_children;

static inline int format_root(const plt_traversal *t, const plt_packet *p, format_entry *e) {
    e->groups = p->active;
    return t->scene->list.count > 0;
}

static inline int format_is_leaf(const format_entry *e) {
    (void)e;
    return 1;
}

static inline int format_is_edge(const format_entry *e) {
    (void)e;
    return 0;
}

static inline int format_resume(const plt_traversal *t, const plt_packet *p, format_entry *e) {
    e->groups = plt_box_groups(&p->slabs, &t->scene->box, e->groups);
    return PLT_OK;
}

static inline int format_enter(const plt_traversal *t, const plt_packet *p, const format_entry *e) {
    (void)t;
    (void)p;
    (void)e;
    return PLT_OK;
}

static inline void format_decode(const plt_traversal *t, const format_entry *e,
                                 format_children *c) {
    (void)e;
    c->box[0] = c->box[1] = t->scene->box;
}

static inline const plt_box *format_boxes(const format_children *c) {
    return c->box;
}

static inline void format_child(const format_children *c, unsigned child, plt_mask groups,
                                format_entry *e) {
    (void)c;
    (void)child;
    e->groups = groups;
}

static inline int format_leaf(plt_traversal *t, plt_packet *p, const format_entry *e) {
    const plt_list *list = &t->scene->list;
    const float longest = plt_box_longest_side(&t->scene->box);
    for (uint32_t i = 0; i < list->count; i++) {
        plt_record_groups(p, &list->records[i], longest, e->groups);
    }
    t->stats.triangle_tests += (uint64_t)list->count * plt_mask_count(e->groups);
    return PLT_OK;
}

#endif
