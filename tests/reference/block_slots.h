/* block_slots - what the engine's traversal works out in passing, asked of a block
 *
 * SPDX-License-Identifier: MIT */
#ifndef TESTS_REFERENCE_BLOCK_SLOTS_H
#define TESTS_REFERENCE_BLOCK_SLOTS_H

#include "engine/tree/compact/block.h"

/* Pairs among the leaves before slot `slot`. */
static inline uint32_t block_pairs(const plt_block *b, uint32_t slot) {
    return b->pairs_before[slot >> 5] +
           plt_count_bits(b->pair[slot >> 5] & plt_low_bits(slot & 31));
}

/* Both children's boxes of node `node`, given its own. */
static inline void block_children(const plt_block *b, uint32_t node, const plt_lattice_box *box,
                                  plt_lattice_box child[2]) {
    /* xmin is always the right child's: five bits are stored. */
    const uint32_t owners = plt_bits_get(b->owners, 5 * node, 5) << 1 | 1u;
    plt_block_apply(box, b->planes + 6 * node, owners, child);
}

#endif
