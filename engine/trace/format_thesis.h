/* format_thesis - thesis nodes and float records; the operations of format.h
 *
 * Source: Karrenberg 2007, sections 3.1 to 3.5 and 4.1.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_FORMAT_THESIS_H
#define PLT_TRACE_FORMAT_THESIS_H

#include "engine/trace/format.h"
#include "engine/trace/leaf_records.h"
#include "engine/trace/treelet_entry.h"

enum { FORMAT_TIGHTENS = 0 };

typedef plt_treelet_state format_state;

static inline void format_state_init(format_state *state) {
    state->block = PLT_MISS;
}

typedef struct format_place {
    plt_box box;
    uint32_t link;
} format_place;

typedef struct format_children {
    const plt_node *node;
    plt_box box[2];
} format_children;

typedef struct format_room {
    char none; /* a place has its box in it */
} format_room;

static inline int format_root(plt_traversal *t, format_place *place) {
    const plt_tree *tree = &t->scene->thesis;
    place->box = t->scene->box;
    place->link = tree->root;
    format_state_init((format_state *)t->state);
    return tree->root != PLT_LINK_NONE;
}

static inline int format_is_leaf(const format_place *place) {
    return plt_link_is_leaf(place->link);
}

static inline int format_is_edge(const format_place *place) {
    return !plt_link_is_inner(place->link);
}

static inline const plt_box *format_box(const plt_traversal *t, const format_place *place,
                                        format_room *room) {
    (void)t;
    (void)room;
    return &place->box;
}

static inline int format_enter(plt_traversal *t, const format_place *place) {
    plt_treelet_enter(t, place->link);
    return PLT_OK;
}

static inline int format_return(plt_traversal *t, const format_place *place) {
    return format_is_leaf(place) ? PLT_OK : format_enter(t, place);
}

/* Both children are asked for before it is known which are hit: a cache line too many
 * costs less than one that is late. */
static inline void prefetch_child(const plt_tree *tree, uint32_t link) {
    if (plt_link_is_leaf(link)) {
        plt_prefetch(&tree->records[plt_link_index(link)]);
    } else {
        plt_prefetch(&tree->nodes[plt_link_index(link)]);
    }
}

static inline void format_decode(const plt_traversal *t, const format_place *place,
                                 format_children *c) {
    const plt_tree *tree = &t->scene->thesis;
    c->node = &tree->nodes[plt_link_index(place->link)];
    prefetch_child(tree, plt_node_link(c->node, 0));
    prefetch_child(tree, plt_node_link(c->node, 1));
    plt_node_decode(c->node, &place->box, c->box);
}

static inline const plt_box *format_boxes(const format_children *c) {
    return c->box;
}

static inline void format_child(const format_children *c, unsigned child, format_place *place) {
    place->box = c->box[child];
    place->link = plt_node_link(c->node, (int)child);
}

static inline int format_leaf(plt_traversal *t, plt_packet *p, const format_place *place,
                              plt_mask groups) {
    const plt_record *record = &t->scene->thesis.records[plt_link_index(place->link)];
    const uint32_t tested = plt_mask_count(groups);
    const float longest = plt_box_longest_side(&place->box);
    for (uint32_t lists = plt_link_lists(place->link); lists > 0; record++) {
        plt_record_groups(p, record, longest, groups);
        t->stats.triangle_tests += tested;
        lists -= (uint32_t)plt_record_is_last(record);
    }
    return PLT_OK;
}

static inline uint32_t format_count(const plt_traversal *t, const format_place *place) {
    const plt_record *first = &t->scene->thesis.records[plt_link_index(place->link)];
    const plt_record *at = first;
    for (uint32_t lists = plt_link_lists(place->link); lists > 0; at++) {
        lists -= (uint32_t)plt_record_is_last(at);
    }
    return (uint32_t)(at - first);
}

static inline void format_triangle(const plt_traversal *t, const format_place *place,
                                   uint32_t index, plt_triangle *to) {
    const plt_record *record = &t->scene->thesis.records[plt_link_index(place->link) + index];
    plt_record_corners(record, to->corner);
    to->word = plt_get_u32(&record->word[9]);
    to->ids = NULL;
}

#endif
