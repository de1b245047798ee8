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

#include "engine/planelet_config.h"
#include "engine/tree/thesis/node.h"

typedef struct plt_treelet_job {
    plt_node *nodes; /* `count` nodes in any order, node 0 is the root */
    uint32_t count;
    uint32_t room;             /* slots in `nodes` */
    uint32_t treelet_nodes;    /* N */
    void *scratch;             /* plt_treelet_scratch_bytes */
    uint32_t node_slots, root; /* results */
} plt_treelet_job;

/* What is kept of it between steps. */
typedef struct plt_treelet_forming {
    plt_node *nodes;
    uint32_t count, room, size; /* size: N */
    uint32_t blocks;
    uint32_t stack;    /* top of the edges that wait */
    uint32_t *target;  /* [count] */
    uint32_t *members; /* [min(count, N)] */
    uint32_t *partial; /* [N] first treelet of that size that waits for its slot */
    uint32_t *head;    /* [N] first block whose free slot has that size */
    uint32_t *sizes;   /* [N / 32 + 1] */
    uint32_t *next;    /* [blocks] */
    uint32_t *used;    /* [blocks] */
    uint32_t root;     /* result, with blocks */
    uint32_t at;       /* size, node or block that a phase goes on with */
    uint32_t left;     /* nodes that are left of the step */
    uint32_t from;     /* where the node was ... */
    plt_node carried;  /* ... that is on its way, if one is */
    uint8_t phase, is_carrying;
} plt_treelet_forming;

/* Slots that `count` nodes can take at most: about twice as many, since all
 * blocks but one are at least half full. */
uint32_t plt_treelet_slots_bound(uint32_t count, uint32_t treelet_nodes);

size_t plt_treelet_scratch_bytes(uint32_t count, uint32_t treelet_nodes);

/* Reorders `nodes` in place, sets the PLT_LINK_OUT bits and zeroes unused
 * slots. Returns PLT_OK or PLT_ERR_ARENA (room too small; nodes are spoilt). */
int plt_treelets_form(plt_treelet_job *job);

#if PLT_WITH_REBUILD
/* The same in steps, of one node and more; then there are `blocks` of N slots, and `root`. Each
 * step goes over about `nodes`, of one treelet at least: PLT_MORE, PLT_OK or PLT_ERR_ARENA. */
void plt_treelets_begin(plt_treelet_forming *forming, const plt_treelet_job *job);
int plt_treelets_step(plt_treelet_forming *forming, uint32_t nodes);
#endif

#endif
