/* forming - treelets of any binary tree: which nodes are together, and in which slots
 *
 * What the engine forms of thesis nodes (engine/tree/thesis/treelets.h), with more choices and the
 * heap: the tree is given by its children alone, so that nodes of any layout can be put into
 * treelets. With TREELET_FILL_BFS and TREELET_SLOTS_THESIS slots are the engine's.
 *
 * Invariants: a treelet is connected, its nodes lie in consecutive slots of one block of N,
 * breadth first. One that edges leave for others has N nodes, so it fills its block; treelets in
 * blocks that others share have no edges but leaves. The root is in slot 0.
 *
 * Source: Karrenberg 2007, sections 4.1, 8.2.1 and 8.2.2.
 *
 * SPDX-License-Identifier: MIT */
#ifndef TREELETS_FORMING_H
#define TREELETS_FORMING_H

#include "host_tools/treelets/treelet_tree.h"

typedef struct treelet_layout {
    uint32_t *slot;    /* of each node */
    uint32_t *treelet; /* of each node: the number of its treelet; the root's is 0 */
    uint8_t *parity;   /* of each treelet: 0 or 1, the root's 0, and the other one behind edges
                        * that leave it (4.1) */
    uint32_t treelets; /* numbered depth first */
    uint32_t complete; /* treelets of N nodes */
    uint32_t blocks;   /* of N slots */
    uint32_t unfilled_blocks; /* blocks with free slots: the thesis's "incomplete treelets" */
} treelet_layout;

/* 0; TREELETS_NO_MEMORY; TREELETS_NO_ROOM: more than 2^32 - 1 slots, which takes another rule, or
 * a smaller N. Then there is no layout. */
enum { TREELETS_NO_MEMORY = -1, TREELETS_NO_ROOM = -2 };
int treelets_form(treelet_layout *to, const treelet_tree *tree, const treelet_wish *wish);
void treelets_free(treelet_layout *layout);

/* Whether the edge from node `from` to its child `to` leaves the treelet: the direct bit. */
static inline int treelets_leaves(const treelet_layout *l, uint32_t from, uint32_t to) {
    return l->treelet[from] != l->treelet[to];
}

#endif
