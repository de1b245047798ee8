/* tile_sky - the colour of the sky in the rows of a tile
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_TILE_SKY_H
#define PLT_SHADE_TILE_SKY_H

#include "engine/shade/frame_place.h"
#include "engine/shade/surface.h"

/* Of the tile at `at`, three bytes per row, whether or not it is in the frame; tiles that go from
 * left to right share them. */
static inline void plt_tile_sky(const plt_frame *f, const plt_frame_place *at,
                                uint8_t sky[3 * PLT_TILE_SIDE]) {
    for (uint32_t y = 0; y < PLT_TILE_SIDE; y++) {
        plt_surface_sky(f, at->y + y, &sky[3 * y]);
    }
}

#endif
