/* bvh_pair - the thesis's hierarchy before it becomes one of planes: two whole boxes per node
 *
 * An inner node has its children's boxes; what it leads to are nodes or lists of triangles, which
 * have no nodes. Where both children would be leaves the node is left out, and its parent leads to
 * the list of both (the thesis's intermediate node): so there are as many nodes as the BPH has, and
 * Table 5.1 counts 84 bytes for each of them, in all its eleven rows (BASELINES.md).
 *
 * A packet is held against both boxes of a node, every active ray; it goes to the child first that
 * its direction comes to first along the node's axis.
 *
 * Source: Karrenberg 2007, sections 2.2, 3.1, 3.2 and 5.2.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BVH_PAIR_H
#define BASELINES_BVH_PAIR_H

#include "host_tools/baselines/base/binary_tree.h"
#include "host_tools/baselines/packet/packet_box.h"

typedef struct bvh_pair_link {
    uint32_t first; /* node, or first record */
    uint16_t count; /* of records; 0: a node */
    uint16_t axis;  /* of the node that it leads to */
} bvh_pair_link;

typedef struct bvh_pair_node {
    plt_box box[2];
    bvh_pair_link child[2];
} bvh_pair_node;

_Static_assert(sizeof(bvh_pair_node) == 64, "a line");

enum { BVH_PAIR_THESIS_BYTES = 84 };

typedef struct bvh_pair_tree {
    bvh_pair_node *node; /* owned */
    const plt_record *record;
    plt_box box;
    bvh_pair_link root;
    uint32_t nodes, lists, intermediates; /* lists of both kinds */
    uint32_t room;
} bvh_pair_tree;

/* From a tree of at least one record, whose last bits are set anew where lists are joined. -1: no
 * memory. */
int bvh_pair_make(bvh_pair_tree *t, const binary_tree *from);
void bvh_pair_free(bvh_pair_tree *t);

/* The packet has begun. */
void bvh_pair_trace(const bvh_pair_tree *t, packet_state *p, packet_steps steps);

#endif
