/* treelets - puts nodes into treelets of a fixed number of slots
 *
 * Inside a treelet nodes stand breadth first, treelets follow each other
 * depth first. A treelet that runs out of inner nodes moves into free slots
 * of an earlier one: the exact fit, else the largest, else a block of its own.
 *
 * Source: Karrenberg 2007, section 4.1. On the bunny it reproduces table 5.5,
 * overhead = 32 * (-nodes mod N) bytes, for all nine N; a scene whose large
 * partial treelets leave no small ones to fill up with can stay above that. What the
 * thesis leaves open: the rest of a slot that was filled is free again; edges of a
 * treelet go onto the build stack from left to right; treelets that are not full get
 * their slots last, the largest first (as they come would waste up to a tenth: DESIGN.md,
 * section 5).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_THESIS_TREELETS_H
#define PLT_TREE_THESIS_TREELETS_H

#include <stddef.h>
#include <stdint.h>

#include "engine/tree/thesis/node.h"

typedef struct plt_treelet_job {
    plt_node *nodes; /* `count` nodes in any order, node 0 is the root */
    uint32_t count;
    uint32_t room;             /* slots in `nodes` */
    uint32_t treelet_nodes;    /* N */
    void *scratch;             /* plt_treelet_scratch_bytes */
    uint32_t node_slots, root; /* results */
} plt_treelet_job;

/* Slots that `count` nodes can take at most: about twice as many, since all
 * blocks but one are at least half full. */
uint32_t plt_treelet_slots_bound(uint32_t count, uint32_t treelet_nodes);

size_t plt_treelet_scratch_bytes(uint32_t count, uint32_t treelet_nodes);

/* Reorders `nodes` in place, sets the PLT_LINK_OUT bits and zeroes unused
 * slots. Returns PLT_OK or PLT_ERR_ARENA (room too small; nodes are spoilt). */
int plt_treelets_form(plt_treelet_job *job);

#endif
