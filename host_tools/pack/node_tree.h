/* node_tree - a tree of thesis nodes as children and areas, and put into treelets by them
 *
 * Nodes are numbered depth first, the left child's before the right one's, as the builder makes
 * them.
 *
 * SPDX-License-Identifier: MIT */
#ifndef NODE_TREE_H
#define NODE_TREE_H
#include <stdint.h>

#include "engine/base/box.h"
#include "engine/tree/thesis/node.h"
#include "host_tools/treelets/forming.h"

typedef struct node_tree {
    treelet_tree tree; /* its arrays are owned */
    uint32_t *slot;    /* of each node, where it was; owned */
} node_tree;

/* Of `count` nodes below the root, a node in slot `root`; `box` is the whole tree's. -1: no
 * memory. The tree is valid, and no path has more than PLT_DEPTH_MAX nodes. */
int node_tree_read(node_tree *t, const plt_node *nodes, uint32_t root, uint32_t count,
                   const plt_box *box);
void node_tree_free(node_tree *t);

/* What the bit of a link to a node says. */
enum node_edges {
    NODE_EDGES_DIRECT, /* 1: it leaves the treelet (DESIGN.md, section 4) */
    NODE_EDGES_PARITY  /* the value of the treelet that it leads into (thesis, 4.1) */
};

/* Puts copies of the nodes into the layout's slots, of which `to` has blocks * N; free ones become
 * 0. */
void node_tree_write(const node_tree *t, const treelet_layout *l, uint32_t size,
                     enum node_edges edges, const plt_node *from, plt_node *to);

#endif
