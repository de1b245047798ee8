/* format_thesis - thesis nodes and float records; the operations of format.h
 *
 * Source: Karrenberg 2007, sections 3.1 to 3.5 and 4.1.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_FORMAT_THESIS_H
#define PLT_TRACE_FORMAT_THESIS_H

#include "engine/memory/traffic.h"
#include "engine/trace/boxes.h"
#include "engine/trace/format.h"
#include "engine/trace/leaf_records.h"

typedef struct format_entry {
    plt_box box;
    uint32_t link;
    float distance; /* two-stage only */
    plt_mask groups;
} format_entry;

typedef struct format_children {
    const plt_node *node;
    plt_box box[2];
} format_children;

static inline int format_root(plt_traversal *t, const plt_packet *p, format_entry *e) {
    const plt_tree *tree = &t->scene->thesis;
    const format_entry root = {t->scene->box, tree->root, 0.0f, p->active};
    *e = root;
    t->treelet = PLT_MISS;
    return tree->root != PLT_LINK_NONE;
}

static inline int format_is_leaf(const format_entry *e) {
    return plt_link_is_leaf(e->link);
}

static inline int format_is_edge(const format_entry *e) {
    return !plt_link_is_inner(e->link);
}

static inline const plt_box *format_box(const format_entry *e) {
    return &e->box;
}

/* Counts the treelet block of the entry's node if it is not the one in hand. */
static inline int format_enter(plt_traversal *t, const plt_packet *p, const format_entry *e) {
    const uint32_t nodes = t->scene->thesis.treelet_nodes;
    const uint32_t treelet = plt_link_index(e->link) / nodes;
    (void)p;
    if (treelet != t->treelet) {
        t->treelet = treelet;
        t->stats.treelet_fetches++;
        plt_traffic_count(&t->stats, t->touched, treelet, nodes * PLT_NODE_BYTES);
    }
    return PLT_OK;
}

static inline int format_resume(plt_traversal *t, const plt_packet *p, format_entry *e) {
    e->groups = plt_box_groups(&p->slabs, &e->box, e->groups);
    return e->groups == 0 || format_is_leaf(e) ? PLT_OK : format_enter(t, p, e);
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

static inline void format_decode(const plt_traversal *t, const format_entry *e,
                                 format_children *c) {
    const plt_tree *tree = &t->scene->thesis;
    c->node = &tree->nodes[plt_link_index(e->link)];
    prefetch_child(tree, plt_node_link(c->node, 0));
    prefetch_child(tree, plt_node_link(c->node, 1));
    plt_node_decode(c->node, &e->box, c->box);
}

static inline const plt_box *format_boxes(const format_children *c) {
    return c->box;
}

static inline void format_child(const format_children *c, unsigned child, plt_mask groups,
                                format_entry *e) {
    e->box = c->box[child];
    e->link = plt_node_link(c->node, (int)child);
    e->groups = groups;
}

static inline int format_leaf(plt_traversal *t, plt_packet *p, const format_entry *e) {
    const plt_record *record = &t->scene->thesis.records[plt_link_index(e->link)];
    const uint32_t concerned = plt_mask_count(e->groups);
    const float longest = plt_box_longest_side(&e->box);
    for (uint32_t lists = plt_link_lists(e->link); lists > 0; record++) {
        plt_record_groups(p, record, longest, e->groups);
        t->stats.triangle_tests += concerned;
        lists -= (uint32_t)plt_record_is_last(record);
    }
    return PLT_OK;
}

#endif
