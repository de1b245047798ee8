/* treelet_tree - any binary tree, and what treelets of it are to be like
 *
 * Source: Karrenberg 2007, sections 4.1, 8.2.1 and 8.2.2.
 *
 * SPDX-License-Identifier: MIT */
#ifndef TREELETS_TREELET_TREE_H
#define TREELETS_TREELET_TREE_H

#include <stddef.h>
#include <stdint.h>

#define TREELET_NO_NODE 0xFFFFFFFFu
#define TREELET_FULL_MOST 10000u /* N of TREELET_FILL_FULL */

/* Nodes are inner ones; what has no nodes below it, a leaf of any kind, is none. */
typedef struct treelet_tree {
    const uint32_t (*child)[2]; /* of each node; TREELET_NO_NODE: a leaf */
    const float *area;          /* of each node's box, 0 and more; for TREELET_FILL_AREA and _FULL.
                                 * NULL: all are the same */
    uint32_t nodes;             /* node 0 is the root, the others have any order */
} treelet_tree;

/* How nodes are chosen until there are N, or no more. */
enum treelet_fill {
    TREELET_FILL_BFS,  /* breadth first (4.1) */
    TREELET_FILL_AREA, /* the node with the largest box of those that are next (8.2.1) */
    TREELET_FILL_FULL, /* so that as few treelets as possible have less than N (8.2.2) */
    TREELET_FILLS
};

/* Where treelets of less than N nodes go. A block that has no room for any of them is new. */
enum treelet_slots {
    TREELET_SLOTS_THESIS, /* after all others, the largest first: where they fit exactly, else
                           * where most is free */
    TREELET_SLOTS_NEWEST, /* as they come, into the newest block that has room */
    TREELET_SLOTS_NONE,   /* into a block of their own */
    TREELET_SLOTS_COME,   /* as they come: where they fit exactly, else where most is free */
    TREELET_SLOT_RULES
};

typedef struct treelet_wish {
    uint32_t size; /* N, 1 and more; TREELET_FILL_FULL: at most TREELET_FULL_MOST */
    uint8_t fill, slots;
} treelet_wish;

#endif
