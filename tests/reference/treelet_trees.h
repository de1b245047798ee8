/* treelet_trees - binary trees of any number of nodes, without boxes or triangles
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_TREELET_TREES_H
#define REFERENCE_TREELET_TREES_H

#include <stdlib.h>

#include "engine/tree/thesis/node.h"
#include "host_tools/treelets/forming.h"
#include "tests/reference/random.h"

typedef struct treelet_tree_made {
    uint32_t (*child)[2];
    float *area;
    treelet_tree tree;
} treelet_tree_made;

/* Of those below a node at least so much of 16 is on each side. */
enum treelet_shape { TREELETS_RAGGED = 0, TREELETS_AS_BUILT = 5, TREELETS_EVEN = 8 };

/* Nodes are numbered depth first. Areas fall by a factor per level. */
static inline treelet_tree_made treelet_tree_make(uint32_t nodes, enum treelet_shape shape,
                                                  random_state *r) {
    treelet_tree_made t = {
        calloc(nodes + 1, sizeof *t.child), calloc(nodes + 1, sizeof *t.area), {NULL, NULL, nodes}};
    uint32_t(*stack)[2] = calloc(nodes + 1, sizeof *stack), waiting = 1; /* node, nodes */
    stack[0][1] = nodes;
    t.area[0] = 1.0f;
    while (waiting > 0) {
        const uint32_t node = stack[--waiting][0], below = stack[waiting][1] - 1;
        const uint32_t least = (uint32_t)((uint64_t)below * shape / 16);
        const uint32_t left = least + random_below(r, below - 2 * least + 1);
        const uint32_t share[2] = {left, below - left}, at[2] = {node + 1, node + 1 + left};
        for (int k = 1; k >= 0; k--) {
            t.child[node][k] = share[k] > 0 ? at[k] : TREELET_NO_NODE;
            if (share[k] > 0) {
                t.area[at[k]] = t.area[node] * random_float(r, 0.4f, 0.8f);
                stack[waiting][0] = at[k];
                stack[waiting++][1] = share[k];
            }
        }
    }
    free(stack);
    t.tree.child = (const uint32_t(*)[2])t.child;
    t.tree.area = t.area;
    return t;
}

static inline void treelet_tree_drop(treelet_tree_made *t) {
    free(t->child);
    free(t->area);
}

/* As the builder leaves them; the planes hold the number of the node, leaves lead to record 0. */
static inline void treelet_tree_nodes(const treelet_tree *t, plt_node *to) {
    for (uint32_t i = 0; i < t->nodes; i++) {
        for (int k = 0; k < 2; k++) {
            const uint32_t child = t->child[i][k];
            plt_node_set_link(&to[i], k,
                              child == TREELET_NO_NODE ? plt_link_make(0, PLT_LINK_LEAF)
                                                       : plt_link_make(child, 0));
        }
        to[i].word[0] = i;
    }
}

#endif
