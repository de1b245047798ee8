/* pack_treelets - treelets of a finished tree, as pack_options want them
 *
 * The builder forms those of the thesis, breadth first. All others are formed here, of the nodes
 * that it has made in treelets of one.
 *
 * --treelet auto tries PACK_TREELET_SIZES and takes the one for which a random line that meets the
 * root's box has least to do: it enters a treelet with the odds of its box's area, which counts as
 * PACK_TREELET_ENTERING nodes beside the nodes that are there, and all of it times slots over
 * nodes. So incomplete treelets count (entered for few nodes), and so do empty slots and the
 * lengths of paths: what section 8.2.3 of the thesis asks for.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_TREELETS_H
#define PACK_TREELETS_H
#include "host_tools/pack/node_tree.h"
#include "host_tools/pack/pack_options.h"

enum { PACK_TREELET_SIZES = 6 }; /* 8, 16 .. 256: those that can be streamed */
#define PACK_TREELET_ENTERING 32.0

/* Whether the builder's own are not what is wanted. */
int pack_treelets_differ(const pack_options *options);

/* How well one size does. */
typedef struct pack_treelet_score {
    uint32_t size, treelets, complete;
    uint64_t free_slots;
    double entered; /* treelets that a random line enters */
    double cost;    /* nodes */
} pack_treelet_score;

typedef struct pack_treelets_stats {
    pack_treelet_score of[PACK_TREELET_SIZES];
    uint32_t tried; /* 1, but for auto; 0: the builder's */
    uint32_t best;  /* of[best] it is */
} pack_treelets_stats;

/* Forms them. 0, or as treelets_form; then there is no layout. `to` is freed by treelets_free. */
int pack_treelets_form(treelet_layout *to, const node_tree *t, const pack_options *options,
                       pack_treelets_stats *stats);

/* The most bytes it takes for so many nodes beside what they take themselves, and slots that they
 * can get. */
uint64_t pack_treelets_bytes(const pack_options *options, uint64_t nodes);
uint64_t pack_treelets_slots(const pack_options *options, uint32_t nodes);

#endif
