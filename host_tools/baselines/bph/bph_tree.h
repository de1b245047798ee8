/* bph_tree - the Bounding Plane Hierarchy in all of its formats
 *
 * Nodes are the thesis's, 32 bytes (tree/thesis/node.h). Lists of K triangles at most end where a
 * record says so; lists of any length have a count beside the link, 40 bytes per node; the two
 * lists of an intermediate node one count, of both: where the second begins is not known then.
 *
 * Source: Karrenberg 2007, chapter 3 and section 8.1.4.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BPH_TREE_H
#define BASELINES_BPH_TREE_H

#include "engine/tree/thesis/node.h"
#include "host_tools/baselines/base/binary_tree.h"

typedef struct bph_format {
    uint32_t most;       /* triangles of a list, K; with counts as many as there are */
    uint8_t has_counts;  /* 1: lists of any length, and counts beside the links */
    uint8_t is_unmerged; /* 1: no intermediate nodes, a node has two lists where it does */
} bph_format;

/* The counts of a node's two links; 0 of a link to a node. */
typedef struct bph_counts {
    uint32_t of[2];
} bph_counts;

enum { BPH_NODE_BYTES = PLT_NODE_BYTES, BPH_COUNTS_BYTES = 8 };

/* What a link leads to, with its count where there are some. */
typedef struct bph_edge {
    uint32_t link, count;
} bph_edge;

typedef struct bph_tree {
    plt_node *node;     /* heap blocks, all three; depth first, 0 is the root, if there is one */
    bph_counts *counts; /* NULL: lists end where records say so */
    plt_record *record; /* lists in the order of the nodes that lead to them */
    bph_format format;
    plt_box box; /* of the root */
    bph_edge root;
    uint32_t nodes, records;
    uint32_t lists, intermediates; /* links to one list, and to two */
    uint32_t levels;               /* nodes on the longest path */
} bph_tree;

enum { BPH_CONVERTED, BPH_NO_MEMORY, BPH_LONG_LIST, BPH_TOO_MANY };

/* Any binary BVH with a root into a tree that has records of its own: boxes of inner nodes are the
 * unions of their children's, and nothing else is asked of it. What is not BPH_CONVERTED left
 * nothing behind. BPH_LONG_LIST: one of more than K; BPH_TOO_MANY: records that an index of 27 bits
 * cannot name. */
int bph_convert(bph_tree *t, const binary_tree *from, const bph_format *format);
void bph_tree_free(bph_tree *t);

static inline uint64_t bph_tree_bytes(const bph_tree *t) {
    return (uint64_t)t->nodes * (BPH_NODE_BYTES + (t->counts != NULL ? BPH_COUNTS_BYTES : 0));
}

static inline bph_edge bph_tree_edge(const bph_tree *t, uint32_t node, int child) {
    const bph_edge e = {plt_node_link(&t->node[node], child),
                        t->counts != NULL ? t->counts[node].of[child] : 0};
    return e;
}

/* Records from the edge's first to the end of its first list, or of both. */
uint32_t bph_list_end(const bph_tree *t, uint32_t first);
uint32_t bph_edge_end(const bph_tree *t, const bph_edge *e);

#endif
