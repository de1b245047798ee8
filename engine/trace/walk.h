/* walk - a packet through a tree, in two orders, a bounded piece at a time
 *
 * A stack entry holds a link, the exact box of what it leads to and the
 * groups that are concerned; distances are taken anew when it is popped, so
 * that hits found meanwhile count. Every order finds the same hits.
 *
 * Stack bounds: the needs in the image's header, which opening has verified
 * (SPEC.md, I8); pushes are not checked again.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WALK_H
#define PLT_TRACE_WALK_H

#include "engine/trace/packet.h"
#include "engine/trace/walk_blocks.h"
#include "engine/tree/thesis/validate.h"

typedef struct plt_walker plt_walker;

typedef struct plt_entry {
    plt_box box;
    uint32_t link;
    float entry; /* distance, for the order of edges (two-stage only) */
    plt_mask groups;
} plt_entry;

struct plt_walker {
    plt_tree tree;
    plt_block_walker blocks;
    uint8_t compact; /* walk `blocks`, not `tree` */
    plt_packet packet;
    plt_entry *stack;  /* depth-first, or the global stack */
    uint32_t waiting;  /* entries on it; 0: the walk is over */
    plt_entry *local;  /* two-stage only */
    uint32_t block;    /* treelet block in hand, PLT_MISS: none */
    uint32_t *touched; /* a bit a block (compact: 8 bytes): already counted */
    plt_stats stats;
};

/* The child whose centre lies further back along the packet's way. */
int plt_walk_nearer(const plt_packet *packet, const float *const lo[2], const float *const hi[2]);

/* Puts the root on the stack; the packet is set up. */
void plt_walk_begin(plt_walker *w);

/* Works off stack entries until about `visits` nodes were visited or the walk
 * is over. Returns the visits that are left (0: more to do, unless
 * `waiting` is 0). */
uint32_t plt_walk_depth_first(plt_walker *w, uint32_t visits);
uint32_t plt_walk_two_stage(plt_walker *w, uint32_t visits);

/* Shared by both orders: one node, its children's boxes and groups; returns
 * which child comes first. */
int plt_walk_visit(plt_walker *w, const plt_entry *at, const plt_node **node, plt_box child[2],
                   plt_mask hit[2]);

/* Tests the lists of a leaf. */
void plt_walk_leaf(plt_walker *w, const plt_entry *leaf);

/* Counts the treelet block of node `index` if it is not the one in hand. */
void plt_walk_enter(plt_walker *w, uint32_t index);

#endif
