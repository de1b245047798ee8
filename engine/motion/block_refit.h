/* block_refit - compact blocks whose triangles have moved
 *
 * Blocks of a sequence have room for any frame: positions of their vertices are lattice
 * coordinates of one width. So all of a block is rewritten where it lies: positions, from the
 * vertices of a frame by their numbers; then bounds, planes and owners, from the boxes of leaves up
 * and from the block's root down. Blocks lie with parents first: the last one is refitted first.
 *
 * Invariant: what is refitted with what it was made of stays as it is, bit for bit; and boxes
 * contain all that is below them. Checks of parts are not kept: a scene that is open needs none.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_BLOCK_REFIT_H
#define PLT_MOTION_BLOCK_REFIT_H

#include "engine/motion/frame_block.h"
#include "engine/tree/compact/block_tree.h"

/* Of a block's children: a box for each slot, in lattice coordinates; the fourth is of no meaning.
 * And the slot that leads to each node. */
typedef struct plt_slot_boxes {
    float lo[2 * PLT_BLOCK_NODES_MOST][4], hi[2 * PLT_BLOCK_NODES_MOST][4];
    uint8_t slot_of[PLT_BLOCK_NODES_MOST];
} plt_slot_boxes;

/* Where the vertices of a frame are, and which of them are those of the blocks. */
typedef struct plt_block_numbers {
    const plt_frame_vertex *vertex; /* four bytes more can be read behind the last one */
    const unsigned char *number;    /* a string of numbers, in the order of the blocks' vertices */
    uint32_t index_bits;            /* of each */
} plt_block_numbers;

typedef struct plt_block_refit {
    uint32_t *address;     /* of each block, in order; NULL: nothing moves */
    plt_slot_boxes *boxes; /* scratch */
    uint32_t blocks;
    uint32_t vertices; /* of all blocks */
} plt_block_refit;

/* Bytes for so many blocks. */
static inline uint64_t plt_block_refit_bytes(uint32_t blocks) {
    return sizeof(plt_slot_boxes) + 4ull * blocks;
}

/* Finds the blocks of a valid tree. `room`: plt_block_refit_bytes, aligned to 4. */
void plt_block_refit_open(plt_block_refit *r, void *room, const plt_block_tree *tree);

/* All blocks, which lie at `blocks`, to what the vertices are now; primitive ids, if the tree has
 * any, at `ids`, to what turns corners now. Sets the box of the tree. */
void plt_block_refit_all(const plt_block_refit *r, plt_block_tree *tree, unsigned char *blocks,
                         unsigned char *ids, const plt_block_numbers *numbers);

#endif
