/* treelet_trees - other trees than the thesis's hierarchy in treelets, which suit any
 *
 * Nodes have fixed sizes and a link to each child, so that they can stand in any slot; leaves are
 * links. In words of 4 bytes: two boxes, or the planes of one axis, then both links, which are the
 * thesis's (engine/tree/thesis/link.h); the axis stands in bits 2 and 3 of the first.
 *
 * Source: Karrenberg 2007, chapter 1 ("Treelets can be applied to any spatial index structure")
 * and section 4.1.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_TREELET_TREES_H
#define BASELINES_TREELET_TREES_H

#include "host_tools/baselines/planes/planes_axis.h"
#include "host_tools/baselines/treelets/treelet_nodes.h"

enum treelet_form {
    TREELET_BVH, /* both children's boxes: 56 bytes */
    TREELET_BKD, /* across one axis, both planes of each: 24 bytes */
    TREELET_BIH, /* the inner ones: 16 bytes */
    TREELET_FORMS
};

typedef struct treelet_trees {
    uint32_t *word; /* of blocks * N slots; owned */
    treelet_nodes nodes;
    enum treelet_form form;
    uint32_t inner, leaves;
    uint32_t treelets, complete, blocks, unfilled_blocks, size;
} treelet_trees;

uint32_t treelet_form_words(enum treelet_form form); /* of a node */

/* Of a binary tree of some nodes, whose boxes are lost, and whose records stay its owner's. -1: no
 * memory, or more slots than links can tell, and there is nothing. */
int treelet_trees_make(treelet_trees *to, binary_tree *t, enum treelet_form form,
                       const treelet_wish *wish);
void treelet_trees_free(treelet_trees *t); /* one that is all zero is allowed */

#endif
