/* reinsert - see reinsert.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/reinsert.h"

/* A gain is a difference of areas, which have 53 bits: less than this share of the root's area
 * may be rounding. (Of poses areas have 24; moves that gain nothing but rounding do no harm, as
 * passes end when they gain less than 0.1 % together, see quality.c.) */
#define GAIN_LEAST 1e-12

typedef struct candidate {
    double freed; /* area that is saved before the node is put in somewhere below here */
    uint32_t node;
} candidate;

typedef struct search {
    const list_tree *t;
    uint32_t node;
    double gain; /* the best so far, and where */
    uint32_t at;
} search;

static uint32_t sibling_of(const list_tree *t, uint32_t node) {
    const list_tree_node *parent = &t->node[t->node[node].parent];
    return parent->child[parent->child[0] == node];
}

/* Inner nodes above. */
static uint32_t depth_of(const list_tree *t, uint32_t node) {
    uint32_t depth = 0;
    for (; node != 0; node = t->node[node].parent) {
        depth++;
    }
    return depth;
}

/* With the node beside it below a new parent, no path is too long. */
static int has_room(const search *s, uint32_t at) {
    const uint32_t mine = s->t->node[s->node].height, its = s->t->node[at].height;
    return depth_of(s->t, at) + 1 + (mine > its ? mine : its) <= PLT_DEPTH_MAX;
}

/* Looks for a better place beside every node of a subtree, and leaves out what cannot have
 * one: the new parent's area is at least the node's own. */
static void search_below(search *s, double freed, uint32_t top) {
    const list_tree_boxes mine = list_tree_boxes_of(s->t, s->node);
    const double least = s->t->node[s->node].area;
    candidate stack[PLT_DEPTH_MAX + 2] = {{freed, top}};
    uint32_t depth = 1;
    while (depth > 0) {
        const candidate c = stack[--depth];
        const list_tree_node *n = &s->t->node[c.node];
        if (c.freed - least <= s->gain) {
            continue;
        }
        const list_tree_boxes its = list_tree_boxes_of(s->t, c.node);
        const double gain = c.freed - list_tree_area(s->t, &its, &mine);
        if (gain > s->gain && has_room(s, c.node)) {
            s->gain = gain;
            s->at = c.node;
        }
        if (!list_tree_is_list(n)) { /* below it, its own box grows to the same union */
            stack[depth++] = (candidate){gain + n->area, n->child[1]};
            stack[depth++] = (candidate){gain + n->area, n->child[0]};
        }
    }
}

/* From the node upwards: below each ancestor's other child. Ancestors shrink meanwhile, those
 * that hold the new place excepted. */
static void search_all(search *s) {
    const list_tree *t = s->t;
    const uint32_t parent = t->node[s->node].parent;
    uint32_t other = sibling_of(t, s->node), above = parent;
    plt_box box, posed[POSES_MOST];
    const list_tree_boxes rest = {&box, posed};
    list_tree_boxes its = list_tree_boxes_of(t, other);
    list_tree_boxes_copy(t, &rest, &its);
    double freed = t->node[parent].area;
    for (;;) {
        search_below(s, freed, other);
        if (above != parent) {
            its = list_tree_boxes_of(t, other);
            list_tree_boxes_add(t, &rest, &its);
            freed += t->node[above].area - list_tree_area(t, &rest, &rest);
        }
        if (above == 0) {
            return;
        }
        other = sibling_of(t, above);
        above = t->node[above].parent;
    }
}

static void replace_child(list_tree *t, uint32_t parent, uint32_t old, uint32_t now) {
    list_tree_node *n = &t->node[parent];
    n->child[n->child[1] == old] = now;
    t->node[now].parent = parent;
}

static void fit_upwards(list_tree *t, uint32_t node) {
    list_tree_fit(t, node);
    while (node != 0) {
        node = t->node[node].parent;
        list_tree_fit(t, node);
    }
}

/* The parent goes along, as the new parent of both. */
static void move(list_tree *t, uint32_t node, uint32_t at) {
    const uint32_t parent = t->node[node].parent, above = t->node[parent].parent;
    replace_child(t, above, parent, sibling_of(t, node));
    replace_child(t, t->node[at].parent, at, parent);
    t->node[parent].child[0] = at;
    t->node[parent].child[1] = node;
    t->node[at].parent = parent;
    fit_upwards(t, parent);
    fit_upwards(t, above);
}

int reinsert(list_tree *t, uint32_t node) {
    if (node == 0 || t->node[node].parent == 0) {
        return 0; /* the root stays what it is */
    }
    search s = {t, node, GAIN_LEAST * t->node[0].area, LIST_TREE_NONE};
    search_all(&s);
    if (s.at == LIST_TREE_NONE) {
        return 0;
    }
    move(t, node, s.at);
    return 1;
}
