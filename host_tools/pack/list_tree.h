/* list_tree - a thesis tree as a plain binary one that can be changed
 *
 * Its leaves are lists of records. Every node knows its box, parent and children; intermediate
 * nodes are nodes like all others.
 * Invariant: an inner node's box is the union of its children's, its area that of the box, its
 * height one more than the greater of theirs. With poses each node has a box in each of them, too.
 *
 * SPDX-License-Identifier: MIT */
#ifndef LIST_TREE_H
#define LIST_TREE_H
#include <stddef.h>
#include <stdint.h>

#include "engine/base/box.h"
#include "engine/builder/build.h"
#include "engine/lanes/lanes.h"
#include "host_tools/pack/poses.h"

#define LIST_TREE_NONE 0xFFFFFFFFu

typedef struct list_tree_node {
    plt_box box;
    double area; /* half the surface, from single precision without rounding that matters; with
                  * poses the weighted sum of those */
    uint32_t parent;
    uint32_t child[2];  /* of a list: its first record, LIST_TREE_NONE */
    uint32_t triangles; /* below it */
    uint32_t height;    /* inner nodes below on the longest path, itself included; a list's is 0 */
} list_tree_node;

typedef struct list_tree {
    list_tree_node *node; /* node 0 is the root */
    uint32_t nodes;
    const poses *poses; /* NULL: the records are all there is */
    plt_box *posed;     /* of each node, one per pose */
} list_tree;

static inline int list_tree_is_list(const list_tree_node *n) {
    return n->child[1] == LIST_TREE_NONE;
}

static inline double list_tree_half_area(const plt_box *b) {
    const double x = (double)b->hi[0] - (double)b->lo[0];
    const double y = (double)b->hi[1] - (double)b->lo[1];
    const double z = (double)b->hi[2] - (double)b->lo[2];
    return x * y + y * z + z * x;
}

/* A node's boxes in the poses; NULL: there are none. */
static inline plt_box *list_tree_posed(const list_tree *t, uint32_t node) {
    return t->poses == NULL ? NULL : t->posed + (size_t)node * t->poses->count;
}

/* Half the surface of the box that holds both, in single precision. */
static inline float list_tree_posed_area(const plt_box *a, const plt_box *b) {
    const float *p = (const float *)(const void *)a, *q = (const float *)(const void *)b;
    const f4 lo = f4_min(f4_load(p), f4_load(q)); /* x y z and one that means nothing */
    const f4 hi = f4_rotate(f4_max(f4_load(p + 2), f4_load(q + 2)));
    const f4 side = f4_sub(hi, lo);
    float area[4];
    f4_store(area, f4_mul(side, f4_turn(side)));
    return area[0] + area[1] + area[2];
}

/* A node's boxes: where the records are, and in the poses. */
typedef struct list_tree_boxes {
    plt_box *box, *posed;
} list_tree_boxes;

static inline list_tree_boxes list_tree_boxes_of(const list_tree *t, uint32_t node) {
    const list_tree_boxes b = {&t->node[node].box, list_tree_posed(t, node)};
    return b;
}

/* The area of a node that holds both; of `a` alone if they are one. */
static inline double list_tree_area(const list_tree *t, const list_tree_boxes *a,
                                    const list_tree_boxes *b) {
    plt_box both = *a->box;
    plt_box_add(&both, b->box);
    if (t->poses == NULL) {
        return list_tree_half_area(&both);
    }
    double sum = t->poses->weight[0] * list_tree_half_area(&both);
    for (uint32_t i = 0; i < t->poses->count; i++) {
        sum += t->poses->weight[i + 1] * (double)list_tree_posed_area(&a->posed[i], &b->posed[i]);
    }
    return sum;
}

/* `a` becomes what holds both. */
static inline void list_tree_boxes_add(const list_tree *t, const list_tree_boxes *a,
                                       const list_tree_boxes *b) {
    plt_box_add(a->box, b->box);
    for (uint32_t i = 0; t->poses != NULL && i < t->poses->count; i++) {
        plt_box_add(&a->posed[i], &b->posed[i]);
    }
}

static inline void list_tree_boxes_copy(const list_tree *t, const list_tree_boxes *to,
                                        const list_tree_boxes *from) {
    *to->box = *from->box;
    for (uint32_t i = 0; t->poses != NULL && i < t->poses->count; i++) {
        to->posed[i] = from->posed[i];
    }
}

/* Box, area, triangles and height of an inner node, from its children. */
void list_tree_fit(list_tree *t, uint32_t node);
/* Makes the node the list of records [first, end). */
void list_tree_fit_list(list_tree *t, uint32_t node, const plt_record *records, uint32_t first,
                        uint32_t end);

/* Nodes of the tree that the job has built: 2 * lists - 1. */
uint32_t list_tree_nodes(const plt_build_job *job);
/* Reads that tree; `t->node` and `t->posed` have room for its nodes. */
void list_tree_read(list_tree *t, const plt_build_job *job);
/* Makes it the job's: nodes in treelets, and `to`, which gets the job's records in the tree's
 * order. The job's own records are as they were. A subtree of at most K triangles becomes one
 * list. PLT_OK, or what plt_treelets_form returns. */
int list_tree_write(const list_tree *t, plt_build_job *job, plt_record *to);

/* Areas of all inner nodes over the root's: how many of their boxes a random line meets that
 * meets the root's; with poses the mean over them. 0 if the root's area is. */
double list_tree_cost(const list_tree *t);

#endif
