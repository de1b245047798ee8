/* kd_tree - nodes of 8 bytes, leaves that name their triangles, and cells that are not split yet
 *
 * A leaf's items are its references, then the number of its strays, then those.
 *
 * Source: Wald, "Realtime ray tracing and interactive global illumination", 2004, section 7 (nodes
 * of 8 bytes).
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_KD_TREE_H
#define BASELINES_KD_TREE_H

#include "host_tools/baselines/kd/kd_cell.h"

/* Inner: `plane` across axis link & 3, the lower child is node link >> 2, the upper the next one.
 * Leaf: link & 3 is 3, link >> 2 the number of references, `first` the first item. Not split yet:
 * link is KD_UNSPLIT, `first` the cell. */
typedef struct kd_node {
    union {
        float plane;
        uint32_t first;
    } at;
    uint32_t link;
} kd_node;

enum { KD_LEAF = 3, KD_LINK_MOST = 0x3FFFFFFE };
#define KD_UNSPLIT 0xFFFFFFFFu

typedef struct kd_tree {
    kd_node *node; /* 0 is the root */
    uint32_t *item;
    kd_cell *cell;
    uint32_t nodes, items, cells;
    uint32_t node_room, item_room, cell_room;
    float lo[3], hi[3];
    uint32_t inner, leaves, unsplit, references, strays; /* counts */
    uint64_t work;                                       /* references of cells that were split */
    uint64_t cell_bytes;                                 /* of those that are not */
} kd_tree;

/* Empties it, and keeps its memory; the root is the cell, which is the tree's from now on, whatever
 * is returned. -1: no memory, here and below. `work` stays. */
int kd_tree_begin(kd_tree *t, const kd_cell *root);
void kd_tree_free(kd_tree *t);
uint64_t kd_tree_bytes(const kd_tree *t); /* in use */

/* The cell of a node that is not split, which the tree has no longer. */
kd_cell kd_tree_take(kd_tree *t, uint32_t node);

/* What such a node becomes. A leaf's cell stays the caller's; cells become the tree's, whatever is
 * returned, but those without any triangle leaves at once. */
int kd_tree_set_leaf(kd_tree *t, uint32_t node, const kd_cell *c);
int kd_tree_set_inner(kd_tree *t, uint32_t node, const kd_cut *cut, const kd_cell children[2]);

#endif
