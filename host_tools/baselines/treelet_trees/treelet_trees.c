/* treelet_trees - see treelet_trees.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/treelet_trees/treelet_trees.h"

#include <string.h>

#include "engine/tree/thesis/link.h"
#include "host_tools/base/heap.h"
#include "host_tools/treelets/forming.h"

enum { AXIS_SHIFT = 2, AXIS_MASK = 3, CLEAN = ~PLT_LINK_OWNERS };

static const uint32_t planes_of[TREELET_FORMS] = {12, 4, 2};

uint32_t treelet_form_words(enum treelet_form form) {
    return planes_of[form] + 2;
}

/* ---- nodes as they are traversed ------------------------------------------------------ */

static void clip(plt_box *b, uint32_t axis, const float *lo, const float *hi) {
    if (lo != NULL && *lo > b->lo[axis]) {
        b->lo[axis] = *lo;
    }
    if (hi != NULL && *hi < b->hi[axis]) {
        b->hi[axis] = *hi;
    }
}

static void children_of(const void *self, uint32_t slot, const plt_box *box,
                        treelet_child child[2]) {
    const treelet_trees *t = self;
    const uint32_t planes = planes_of[t->form], *word = t->word + (size_t)slot * (planes + 2);
    const uint32_t *link = word + planes, axis = link[0] >> AXIS_SHIFT & AXIS_MASK;
    float plane[12];
    memcpy(plane, word, planes * sizeof *plane);
    for (int k = 0; k < 2; k++) {
        child[k] = (treelet_child){*box, link[k] & (uint32_t)CLEAN};
        if (t->form == TREELET_BVH) {
            memcpy(child[k].box.lo, plane + 6 * k, sizeof child[k].box.lo);
            memcpy(child[k].box.hi, plane + 6 * k + 3, sizeof child[k].box.hi);
        } else if (t->form == TREELET_BKD) {
            clip(&child[k].box, axis, &plane[2 * k], &plane[2 * k + 1]);
        } else {
            clip(&child[k].box, axis, k == 1 ? &plane[1] : NULL, k == 0 ? &plane[0] : NULL);
        }
    }
}

/* ---- making ----------------------------------------------------------------------------- */

typedef struct making {
    treelet_trees *to;
    binary_tree *tree;
    planes_cut *cut;      /* of each inner node */
    uint32_t *number;     /* of each node: which inner one it is */
    uint32_t (*child)[2]; /* of each inner node, for forming */
    float *area;
} making;

static int reserve(making *m) {
    const uint64_t nodes = m->tree->nodes, inner = m->to->inner;
    m->cut = heap_get(inner * sizeof *m->cut + 1);
    m->number = heap_get(nodes * sizeof *m->number);
    m->child = heap_get(inner * sizeof *m->child + 1);
    m->area = heap_get(inner * sizeof *m->area + 1);
    return m->cut != NULL && m->number != NULL && m->child != NULL && m->area != NULL ? 0 : -1;
}

static void release(making *m) {
    heap_drop(m->cut);
    heap_drop(m->number);
    heap_drop(m->child);
    heap_drop(m->area);
}

/* Axes and numbers, parents first. */
static int number_nodes(making *m) {
    planes_source s;
    uint32_t inner = 0;
    if (planes_source_begin(&s, m->tree, m->to->form == TREELET_BKD) != 0) {
        return -1;
    }
    for (uint32_t i = 0; i < m->tree->nodes; i++) {
        const binary_node *n = &m->tree->node[i];
        m->number[i] = TREELET_NO_NODE;
        if (!binary_is_leaf(n)) {
            m->cut[inner] = m->to->form == TREELET_BVH ? (planes_cut){.axis = n->axis}
                                                       : planes_source_cut(&s, i);
            m->area[inner] = plt_box_half_area(&n->box);
            m->number[i] = inner++;
        }
    }
    planes_source_end(&s);
    for (uint32_t i = 0; i < m->tree->nodes; i++) {
        const binary_node *n = &m->tree->node[i];
        if (!binary_is_leaf(n)) {
            m->child[m->number[i]][0] = m->number[n->first];
            m->child[m->number[i]][1] = m->number[n->first + 1];
        }
    }
    return 0;
}

static uint32_t link_of(const making *m, const treelet_layout *l, uint32_t node) {
    const uint32_t number = m->number[node];
    if (number == TREELET_NO_NODE) {
        return plt_link_make(m->tree->node[node].first, PLT_LINK_LEAF);
    }
    return plt_link_make(l->slot[number], l->parity[l->treelet[number]] ? PLT_LINK_OUT : 0);
}

static void put_node(const making *m, const treelet_layout *l, uint32_t node) {
    const binary_node *n = &m->tree->node[node], *of = &m->tree->node[n->first];
    const planes_cut *c = &m->cut[m->number[node]];
    const uint32_t planes = planes_of[m->to->form];
    uint32_t *to = m->to->word + (size_t)l->slot[m->number[node]] * (planes + 2);
    const float both[4] = {c->lo[0], c->hi[0], c->lo[1], c->hi[1]}, inner[2] = {c->hi[0], c->lo[1]};
    if (m->to->form == TREELET_BVH) {
        memcpy(to, &of[0].box, 24);
        memcpy(to + 6, &of[1].box, 24);
    } else {
        memcpy(to, m->to->form == TREELET_BKD ? both : inner, planes * sizeof *to);
    }
    to[planes] = link_of(m, l, n->first) | c->axis << AXIS_SHIFT;
    to[planes + 1] = link_of(m, l, n->first + 1);
}

static int put_nodes(making *m, const treelet_wish *wish) {
    const treelet_tree tree = {(const uint32_t(*)[2])m->child, m->area, m->to->inner};
    treelet_layout l = {.slot = NULL};
    if (treelets_form(&l, &tree, wish) != 0) {
        return -1;
    }
    const uint64_t slots = (uint64_t)l.blocks * wish->size;
    const uint64_t bytes = slots * treelet_form_words(m->to->form) * 4;
    m->to->word = slots <= PLT_INDEX_MAX ? heap_get_zeroed(bytes) : NULL;
    for (uint32_t i = 0; i < m->tree->nodes && m->to->word != NULL; i++) {
        if (m->number[i] != TREELET_NO_NODE) {
            put_node(m, &l, i);
        }
    }
    m->to->treelets = l.treelets;
    m->to->complete = l.complete;
    m->to->blocks = l.blocks;
    m->to->unfilled_blocks = l.unfilled_blocks;
    m->to->nodes.root = plt_link_make(l.slot[0], 0);
    treelets_free(&l);
    return m->to->word != NULL ? 0 : -1;
}

int treelet_trees_make(treelet_trees *to, binary_tree *t, enum treelet_form form,
                       const treelet_wish *wish) {
    making m = {.to = to, .tree = t};
    *to = (treelet_trees){.form = form, .size = wish->size, .leaves = t->leaves};
    to->inner = t->nodes - t->leaves;
    to->nodes = (treelet_nodes){.self = to,
                                .children = children_of,
                                .record = t->record,
                                .box = t->node[0].box,
                                .root = plt_link_make(0, PLT_LINK_LEAF),
                                .edges = NODE_EDGES_PARITY};
    int status = reserve(&m) == 0 ? number_nodes(&m) : -1;
    if (status == 0 && to->inner > 0) {
        status = put_nodes(&m, wish);
    }
    release(&m);
    if (status != 0) {
        treelet_trees_free(to);
    }
    return status;
}

void treelet_trees_free(treelet_trees *t) {
    heap_drop(t->word);
    memset(t, 0, sizeof *t);
}
