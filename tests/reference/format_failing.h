/* format_failing - a format of the tests' own, that fails when it is told to
 *
 * Nodes hold both children's boxes as they are, and their links; triangles are float
 * records. It is made of a scene of thesis nodes, with the same treelets. It is all that
 * a new format has to be: the operations of format.h, with a scene around plt_scene.
 *
 * enter, return and leaf are calls that may fail; the plan says which of them does.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_FORMAT_FAILING_H
#define REFERENCE_FORMAT_FAILING_H

#include "engine/trace/format.h"
#include "engine/trace/leaf_records.h"

enum failing_call { FAILING_ENTER, FAILING_RETURN, FAILING_LEAF, FAILING_CALLS };

/* What happens, and what has happened. */
typedef struct failing_plan {
    uint64_t fails_at; /* this call fails, counted from 1; 0: none does */
    int status;        /* with this */
    uint64_t calls[FAILING_CALLS], all;
} failing_plan;

typedef struct failing_node {
    plt_box box[2];
    uint32_t link[2]; /* as in thesis nodes */
} failing_node;

typedef struct failing_scene {
    plt_scene scene; /* first: what a traversal points at */
    const failing_node *nodes;
    failing_plan *plan;
} failing_scene;

static inline const failing_scene *failing_scene_of(const plt_traversal *t) {
    return (const failing_scene *)t->scene;
}

/* Counts a call; its status. */
static inline int failing_status(const plt_traversal *t, enum failing_call call) {
    failing_plan *plan = failing_scene_of(t)->plan;
    plan->calls[call]++;
    return ++plan->all == plan->fails_at ? plan->status : PLT_OK;
}

/* ---- the operations of format.h ---------------------------------------------------- */

enum { FORMAT_TIGHTENS = 1, FORMAT_LEAVES_WAIT = 1 }; /* the boxes stay, the calls are made */

typedef struct format_state {
    char none;
} format_state;

static inline void format_state_init(plt_traversal *t) {
    ((format_state *)t->state)->none = 0;
}

typedef struct format_place {
    plt_box box;
    uint32_t link;
} format_place;

typedef struct format_children {
    const failing_node *node;
} format_children;

typedef struct format_room {
    char none;
} format_room;

static inline int format_root(const plt_traversal *t, format_place *place) {
    place->box = t->scene->box;
    place->link = t->scene->thesis.root;
    return place->link != PLT_LINK_NONE;
}

static inline int format_is_leaf(const format_place *place) {
    return plt_link_is_leaf(place->link);
}

static inline int format_is_edge(const format_place *place) {
    return !plt_link_is_leaf(place->link) && !plt_link_is_inner(place->link); /* not of leaves */
}

static inline const plt_box *format_box(const plt_traversal *t, const format_place *place,
                                        format_room *room) {
    (void)t;
    (void)room;
    return &place->box;
}

static inline int format_enter(const plt_traversal *t, const format_place *place) {
    (void)place;
    return failing_status(t, FAILING_ENTER);
}

static inline int format_cross(const plt_traversal *t, const format_place *place) {
    return format_is_edge(place) ? format_enter(t, place) : PLT_OK;
}

static inline void bounds_of(const plt_box *box, f4 *lo, f4 *hi) {
    *lo = f4_load(box->lo);
    *hi = f4_rotate(f4_load(&box->lo[2]));
}

static inline void format_bounds(const plt_traversal *t, const format_place *place, f4 *lo,
                                 f4 *hi) {
    (void)t;
    bounds_of(&place->box, lo, hi);
}

static inline void format_child_bounds(const format_children *c, unsigned child, f4 *lo, f4 *hi) {
    bounds_of(&c->node->box[child], lo, hi);
}

static inline int format_return(const plt_traversal *t, const format_place *place) {
    (void)place;
    return failing_status(t, FAILING_RETURN);
}

static inline void format_decode(const plt_traversal *t, const format_place *place,
                                 format_children *c) {
    c->node = &failing_scene_of(t)->nodes[plt_link_index(place->link)];
}

static inline const plt_box *format_boxes(const format_children *c) {
    return c->node->box;
}

static inline void format_child(const format_children *c, unsigned child, format_place *place) {
    place->box = c->node->box[child];
    place->link = c->node->link[child];
}

static inline int format_leaf(plt_traversal *t, plt_packet *p, const format_place *place,
                              plt_mask groups) {
    const plt_record *record = &t->scene->thesis.records[plt_link_index(place->link)];
    const int status = failing_status(t, FAILING_LEAF);
    for (uint32_t lists = plt_link_lists(place->link); status == PLT_OK && lists > 0; record++) {
        plt_record_groups(p, record, plt_box_longest_side(&place->box), groups);
        t->stats.triangle_tests += plt_mask_count(groups);
        lists -= (uint32_t)plt_record_is_last(record);
    }
    return status;
}

#endif
