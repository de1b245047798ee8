/* format_failing - a format of the tests' own, that fails when it is told to
 *
 * Nodes hold both children's boxes as they are, and their links; triangles are float
 * records. It is made of a scene of thesis nodes, with the same treelets. It is all that
 * a new format has to be: the operations of format.h, with a scene around plt_scene.
 *
 * enter, resume and leaf are calls that may fail; the plan says which of them does.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_FORMAT_FAILING_H
#define REFERENCE_FORMAT_FAILING_H

#include "engine/trace/boxes.h"
#include "engine/trace/format.h"
#include "engine/trace/leaf_records.h"

enum failing_call { FAILING_ENTER, FAILING_RESUME, FAILING_LEAF, FAILING_CALLS };

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

typedef struct format_entry {
    plt_box box;
    uint32_t link;
    float distance;
    plt_mask groups;
} format_entry;

typedef struct format_children {
    const failing_node *node;
} format_children;

static inline int format_root(plt_traversal *t, const plt_packet *p, format_entry *e) {
    const plt_tree *tree = &t->scene->thesis;
    const format_entry root = {t->scene->box, tree->root, 0.0f, p->active};
    *e = root;
    return tree->root != PLT_LINK_NONE;
}

static inline int format_is_leaf(const format_entry *e) {
    return plt_link_is_leaf(e->link);
}

static inline int format_is_edge(const format_entry *e) {
    return !plt_link_is_leaf(e->link) && !plt_link_is_inner(e->link); /* not of leaves */
}

static inline const plt_box *format_box(const format_entry *e) {
    return &e->box;
}

static inline int format_enter(plt_traversal *t, const plt_packet *p, const format_entry *e) {
    (void)p;
    (void)e;
    return failing_status(t, FAILING_ENTER);
}

static inline int format_resume(plt_traversal *t, const plt_packet *p, format_entry *e) {
    e->groups = plt_box_groups(&p->slabs, &e->box, e->groups);
    return failing_status(t, FAILING_RESUME);
}

static inline void format_decode(const plt_traversal *t, const format_entry *e,
                                 format_children *c) {
    c->node = &failing_scene_of(t)->nodes[plt_link_index(e->link)];
}

static inline const plt_box *format_boxes(const format_children *c) {
    return c->node->box;
}

static inline void format_child(const format_children *c, unsigned child, plt_mask groups,
                                format_entry *e) {
    e->box = c->node->box[child];
    e->link = c->node->link[child];
    e->groups = groups;
}

static inline int format_leaf(plt_traversal *t, plt_packet *p, const format_entry *e) {
    const plt_record *record = &t->scene->thesis.records[plt_link_index(e->link)];
    const int status = failing_status(t, FAILING_LEAF);
    for (uint32_t lists = plt_link_lists(e->link); status == PLT_OK && lists > 0; record++) {
        plt_record_groups(p, record, plt_box_longest_side(&e->box), e->groups);
        t->stats.triangle_tests += plt_mask_count(e->groups);
        lists -= (uint32_t)plt_record_is_last(record);
    }
    return status;
}

#endif
