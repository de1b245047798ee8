/* frame_place - where in a frame: a tile, and a packet within it
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_FRAME_PLACE_H
#define PLT_SHADE_FRAME_PLACE_H

#include "engine/planelet.h"
#include "engine/shade/tile_order.h"

/* Pixels. */
typedef struct plt_frame_place {
    uint32_t x, y, px, py;
#if PLT_WITH_STREAMED
    plt_tile_order order; /* of the tiles of a streamed scene */
#endif
} plt_frame_place;

static inline uint32_t plt_least(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

/* Of the tile; those at the right and at the bottom may be smaller. */
static inline uint32_t plt_tile_width(const plt_frame *f, const plt_frame_place *at) {
    return plt_least(PLT_TILE_SIDE, f->width - at->x);
}

static inline uint32_t plt_tile_height(const plt_frame *f, const plt_frame_place *at) {
    return plt_least(PLT_TILE_SIDE, f->height - at->y);
}

/* Tiles along so many pixels. */
static inline uint32_t plt_tiles_along(uint32_t pixels) {
    return (pixels + PLT_TILE_SIDE - 1u) / PLT_TILE_SIDE;
}

#endif
