/* rendering_sky - the colour of the sky in the rows of a tile
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_RENDERING_SKY_H
#define PLT_SHADE_RENDERING_SKY_H

#include "engine/shade/rendering.h"
#include "engine/shade/surface.h"

/* Of the current tile; rows of tiles that go from left to right share it. */
static inline void plt_rendering_set_sky(plt_rendering *r) {
    for (uint32_t y = 0; y < plt_tile_height(&r->frame, &r->at); y++) {
        plt_surface_sky(&r->frame, r->at.y + y, &r->sky[3 * y]);
    }
}

#endif
