/* treelet_nodes - a binary tree in treelets, as the traversals of treelet_orders.h see it
 *
 * Any structure will do that can say of a node in a slot, and its box, what its two children's
 * boxes are and where they are. Links are the thesis's (engine/tree/thesis/link.h): bit 0, leaf;
 * bit 1 of a leaf, two lists in a row; bit 1 of a node, what `edges` says.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_TREELET_NODES_H
#define BASELINES_TREELET_NODES_H

#include "engine/base/box.h"
#include "engine/tree/record.h"
#include "host_tools/pack/node_tree.h"

typedef struct treelet_child {
    plt_box box; /* around all triangles below */
    uint32_t link;
} treelet_child;

typedef struct treelet_nodes {
    const void *self;
    void (*children)(const void *self, uint32_t slot, const plt_box *box, treelet_child child[2]);
    const plt_record *record; /* the last bit ends each list */
    plt_box box;              /* of all triangles */
    uint32_t root;            /* a link, PLT_LINK_NONE: there is no triangle */
    enum node_edges edges;    /* how an edge that leaves a treelet is told */
} treelet_nodes;

#endif
