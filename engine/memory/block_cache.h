/* block_cache - compact blocks that stay open from visit to visit
 *
 * To open a block is to find its parts and count its masks; walks come back to the
 * same few blocks, and so do packets beside each other. Each block has one place
 * among PLT_OPEN_BLOCKS, by its address; the one that was there has to be opened
 * again when it is met again. Nothing of it can be seen but the time it takes.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MEMORY_BLOCK_CACHE_H
#define PLT_MEMORY_BLOCK_CACHE_H

#include "engine/planelet_config.h"
#include "engine/tree/compact/validate.h"

typedef struct plt_opened_block {
    uint32_t link; /* PLT_MISS: none is here */
    uint8_t geometry_open;
    float lo[4], hi[4]; /* frame, as of plt_block_entry (walk_blocks.h) */
    plt_block block;
    plt_geometry geometry; /* if open */
} plt_opened_block;

/* Forgets all of the PLT_OPEN_BLOCKS places. */
void plt_block_cache_clear(plt_opened_block *places);

/* Puts the block behind `link` in `place`. */
void plt_opened_block_set(plt_opened_block *place, const plt_block_tree *tree, uint32_t link);

/* Opens the geometry part, too. */
void plt_opened_block_geometry(plt_opened_block *open, const plt_block_tree *tree);

/* The block behind `link`, open. */
static inline plt_opened_block *plt_block_cache_find(plt_opened_block *places,
                                                     const plt_block_tree *tree, uint32_t link) {
    /* The golden ratio's bits spread blocks that lie beside each other. */
    const uint32_t spread = plt_block_address(link) / 8 * 0x9E3779B1u >> 16;
    plt_opened_block *place = &places[spread % PLT_OPEN_BLOCKS];
    if (place->link != link) {
        plt_opened_block_set(place, tree, link);
    }
    return place;
}

#endif
