/* open_blocks - compact blocks that stay open from visit to visit
 *
 * To open a block is to find its parts and count its masks; walks come back to the
 * same few blocks, and so do packets beside each other. Each block has one place
 * among PLT_OPEN_BLOCKS, by its address; the one that was there has to be opened
 * again when it is met again. Nothing of it can be seen but the time it takes.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_OPEN_BLOCKS_H
#define PLT_TRACE_OPEN_BLOCKS_H

#include "engine/planelet_config.h"
#include "engine/tree/block_survey.h"

typedef struct plt_open_block {
    uint32_t link; /* PLT_MISS: none is here */
    uint8_t geometry_open;
    float lo[4], hi[4]; /* frame, as of plt_block_entry (walk_blocks.h) */
    plt_block block;
    plt_geometry geometry; /* if open */
} plt_open_block;

/* Forgets all of the PLT_OPEN_BLOCKS places. */
void plt_open_blocks_begin(plt_open_block *places);

/* Puts the block behind `link` in `place`. */
void plt_open_block_set(plt_open_block *place, const plt_block_tree *tree, uint32_t link);

/* Opens the geometry part, too. */
void plt_open_block_geometry(plt_open_block *open, const plt_block_tree *tree);

/* The block behind `link`, open. */
static inline plt_open_block *plt_open_block_find(plt_open_block *places,
                                                  const plt_block_tree *tree, uint32_t link) {
    /* The golden ratio's bits spread blocks that lie beside each other. */
    const uint32_t spread = plt_block_address(link) / 8 * 0x9E3779B1u >> 16;
    plt_open_block *place = &places[spread % PLT_OPEN_BLOCKS];
    if (place->link != link) {
        plt_open_block_set(place, tree, link);
    }
    return place;
}

#endif
