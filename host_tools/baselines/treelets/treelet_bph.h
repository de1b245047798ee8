/* treelet_bph - nodes of six planes in treelets: the thesis's hierarchy as it is to be traversed
 *
 * The tree is the packer's, in treelets of one node, and put into others (host_tools/treelets).
 *
 * Source: Karrenberg 2007, sections 3.3 and 4.1.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_TREELET_BPH_H
#define BASELINES_TREELET_BPH_H

#include "host_tools/baselines/treelets/treelet_nodes.h"
#include "host_tools/pack/pack.h"

typedef struct treelet_bph_options {
    uint8_t splits;          /* enum plt_splits */
    uint32_t leaf_triangles; /* K */
    treelet_wish wish;
    enum node_edges edges;
} treelet_bph_options;

typedef struct treelet_bph {
    plt_node *node; /* owned, blocks * N slots */
    packed image;   /* whose records they lead to */
    treelet_nodes nodes;
    uint32_t treelets, complete, blocks, unfilled_blocks, size;
} treelet_bph;

/* From nothing, all zero. 0, or it says why not, and there is nothing. */
int treelet_bph_make(treelet_bph *b, const mesh *m, const treelet_bph_options *o, const char *name,
                     fail *f);
void treelet_bph_free(treelet_bph *b);

#endif
