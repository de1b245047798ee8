/* block_cache - compact blocks that stay opened from visit to visit
 *
 * To open a block is to find its parts and count its masks. A traversal comes back to
 * the same few blocks, and so does the next packet. The cache is direct-mapped: a
 * block has one slot among PLT_BLOCK_CACHE_SLOTS, by its address, and whatever was in that
 * slot has to be opened again when it is needed again. One cache per traversal.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MEMORY_BLOCK_CACHE_H
#define PLT_MEMORY_BLOCK_CACHE_H

#include "engine/planelet.h"
#include "engine/tree/compact/block_tree.h"

typedef struct plt_opened_block {
    uint32_t link; /* PLT_LINK_NONE: the slot is empty */
    uint8_t geometry_open;
    float lo[4], hi[4]; /* bounds, in lattice coordinates; the fourth means nothing */
    plt_block block;
    plt_geometry geometry; /* if open */
} plt_opened_block;

/* Empties all PLT_BLOCK_CACHE_SLOTS slots. */
void plt_block_cache_clear(plt_opened_block *cache);

/* Opens the block behind `link`, which lies at `bytes`, in `slot`. */
void plt_opened_block_set(plt_opened_block *slot, const unsigned char *bytes,
                          const plt_block_tree *tree, uint32_t link);

/* Opens its geometry part, too, which lies at block.geometry. */
void plt_opened_block_geometry(plt_opened_block *opened, const plt_block_tree *tree);

/* Its slot. The address is multiplied by the golden ratio, so that neighbouring blocks do not
 * collide. */
static inline uint32_t plt_block_cache_slot(uint32_t link) {
    return (plt_block_address(link) / 8 * 0x9E3779B1u >> 16) % PLT_BLOCK_CACHE_SLOTS;
}

/* The block behind `link`, opened. */
static inline plt_opened_block *plt_block_cache_find(plt_opened_block *cache,
                                                     const plt_block_tree *tree, uint32_t link) {
    plt_opened_block *slot = &cache[plt_block_cache_slot(link)];
    if (slot->link != link) {
        plt_opened_block_set(slot, tree->bytes + plt_block_address(link), tree, link);
    }
    return slot;
}

#endif
