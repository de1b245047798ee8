/* seek - a frame goes on with any of its tiles
 *
 * Apart from rendering.c, as only who shares a frame among several engines wants it.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_SEEK_H
#define PLT_SHADE_SEEK_H

#include "engine/shade/rendering.h"

/* As plt_render_tiles and plt_render_seek. */
uint32_t plt_rendering_tiles(const plt_rendering *r);
int plt_rendering_seek(plt_rendering *r, uint32_t tile, uint32_t count);

#endif
