/* binary_tree - boxes around boxes around triangles: what object hierarchies are made from
 *
 * Splits are the engine's (builder/split.h): the spatial median of the thesis, the same topology
 * node for node, or the surface area heuristic. Every node knows its box; children lie beside each
 * other, the one whose centre is lower along the node's axis first.
 * Invariant: a node's box is the tight box of the triangles below it; a tree of at least one
 * triangle has a root, node 0, and one node more than twice as many as are inner.
 *
 * Sources: Karrenberg 2007, sections 3.4 and 6.4; Wald, Boulos, Shirley, "Ray tracing deformable
 * scenes using dynamic bounding volume hierarchies", 2007, sections 3 and 4 (leaves by cost).
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BINARY_TREE_H
#define BASELINES_BINARY_TREE_H

#include "engine/builder/split.h"
#include "engine/tree/record.h"

typedef struct binary_node {
    plt_box box;
    uint32_t first; /* inner: the first child, the other is the next node; leaf: its first record */
    uint16_t count; /* of a leaf's records; 0: inner */
    uint16_t axis;  /* along which the children's centres are farthest apart */
} binary_node;

_Static_assert(sizeof(binary_node) == 32, "two nodes to a line");

typedef struct binary_options {
    uint8_t splits;  /* enum plt_splits */
    uint8_t leaf;    /* triangles that may stay together, 1 .. 255 */
    uint8_t by_cost; /* 1: they do where a split would cost more; 0: always */
    uint8_t by_grid; /* 1: splits are those of binary_halve.h instead */
} binary_options;

/* A test of a box costs as much as that of `BINARY_BOX_COST` triangles. */
#define BINARY_BOX_COST 0.5f

/* Entries of a stack that one child waits on at every level. Halves of 2^27 triangles take 27
 * levels where PLT_DEPTH_MAX is tiny; what may stay together, and does not, 8 more. */
enum { BINARY_DEPTH = (PLT_DEPTH_MAX > 28 ? PLT_DEPTH_MAX : 28) + 10 };

typedef struct binary_tree {
    binary_node *node;             /* on a line of 64 bytes less 32, so that children share one */
    plt_record *record;            /* not owned, permuted; the last bit ends each leaf */
    uint32_t nodes, leaves, depth; /* depth: of nodes on the longest way */
    uint32_t count;                /* of records */
    uint32_t room;                 /* for nodes */
    void *block;
    uint64_t work; /* records of ranges that were split; goes on over builds */
} binary_tree;

/* Of records whose tight box is `box`, in the memory of the last build, if there was one; its
 * `record` stays the caller's. No record: no node. -1: no memory, and the tree is empty. */
int binary_tree_build(binary_tree *t, plt_record *record, uint32_t count, const plt_box *box,
                      const binary_options *o);
void binary_tree_free(binary_tree *t);

static inline int binary_is_leaf(const binary_node *n) {
    return n->count != 0;
}

#endif
