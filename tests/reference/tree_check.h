/* tree_check - an image's tree, read bit by bit and checked by recursion
 *
 * Shares no code with engine/tree: links, planes and lists are decoded here independently, so a
 * mistake there cannot hide.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_TREE_CHECK_H
#define REFERENCE_TREE_CHECK_H

#include <stddef.h>
#include <stdint.h>

#include "host_tools/pack/pack.h"

typedef struct tree_view {
    const unsigned char *nodes, *records;
    uint32_t slots, count, root, treelet_nodes, leaf_triangles;
    float lo[3], hi[3];
    int is_patched; /* subtrees were rebuilt in their slots: treelets are within their blocks, in
                     * any order, and in free slots links alone are 0 */
} tree_view;

typedef struct tree_facts {
    uint32_t nodes, lists, twos, treelets, levels; /* levels: inner nodes on a path */
    uint32_t longest_list, largest_treelet;
    uint32_t local, global, depth; /* stack needs */
    uint32_t broken;               /* rules broken; 0: a good tree */
    const char *sentence;          /* the first of them */
} tree_facts;

tree_view tree_view_of(const packed *image);

/* Boxes tight, lists whole and at most K long, no two lists below a node,
 * treelets connected, breadth first and inside their blocks, bits right,
 * free slots zero. */
tree_facts tree_check(const tree_view *view);

/* The most entries that stacks held in a traversal. At each node `order` returns
 * bits: 0 and 1, whether the left and right child are hit; 2, which one comes
 * first. */
typedef struct tree_traversal {
    unsigned (*order)(void *context, uint32_t node, uint32_t left, uint32_t right);
    void *context;
    uint32_t local, global, depth; /* results */
} tree_traversal;

void tree_traverse_depth_first(const tree_view *view, tree_traversal *traversal);
void tree_traverse_two_stage(const tree_view *view, tree_traversal *traversal);

/* Orders that hit everything and visit first the child that is deeper, or that
 * needs more of the local stack. */
unsigned tree_deepest_order(void *view, uint32_t node, uint32_t left, uint32_t right);
unsigned tree_bushiest_order(void *view, uint32_t node, uint32_t left, uint32_t right);

uint32_t tree_word(const unsigned char *at);
int tree_is_leaf(uint32_t link);

#endif
