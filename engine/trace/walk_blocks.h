/* walk_blocks - a packet through compact blocks, depth first
 *
 * Boxes are decoded once a packet and visit, in whole lattice numbers. They are
 * kept in floats, which hold whole numbers up to 2^24 exactly, so that the
 * 4-lane operations do all three axes at once; a lattice has at most 21 bits.
 * They become planes of the scene just before they are tested: all that
 * follows is what it is for thesis nodes, and hits are the same bit for bit.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WALK_BLOCKS_H
#define PLT_TRACE_WALK_BLOCKS_H

#include "engine/memory/block_cache.h"
#include "engine/trace/packet.h"

/* What a slot leads to: a node of the block, an edge to another, a unit. */
typedef struct plt_block_child {
    uint32_t link; /* of its block; of an edge the block behind it */
    uint32_t what; /* enum plt_slot_kind | number of node or unit << 8 | of a unit: pairs
                      before it << 16 | it is a pair << 24 */
} plt_block_child;

/* What waits. */
typedef struct plt_block_entry {
    float lo[4], hi[4]; /* lattice numbers; the fourth means nothing */
    plt_block_child child;
    plt_mask groups;
} plt_block_entry;

typedef struct plt_block_walker {
    plt_block_tree tree;
    plt_block_entry *stack;
    plt_opened_block *open;    /* PLT_OPEN_BLOCKS places */
    float origin[4];           /* of the lattice, as 4-lane operations load it */
    plt_opened_block *in_hand; /* NULL: none is */
    uint8_t geometry_in_hand;
} plt_block_walker;

/* Lattice numbers to planes of the scene: exact product, one rounding. */
static inline f4 plt_block_planes(const plt_block_walker *b, f4 numbers) {
    return f4_add(f4_load(b->origin), f4_mul(f4_all(b->tree.lattice.step), numbers));
}

struct plt_walker;

/* As plt_walk_begin and plt_walk_depth_first (walk.h). */
void plt_walk_blocks_begin(struct plt_walker *w);
uint32_t plt_walk_blocks(struct plt_walker *w, uint32_t visits);

#endif
