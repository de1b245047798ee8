/* smooth_paint - the textures of smooth frames, which have no lights
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_SMOOTH_PAINT_H
#define PLT_SHADE_SMOOTH_PAINT_H

#include "engine/texture/sample.h"
#include "engine/whitted/materials.h"

#if PLT_WITH_TEXTURE

typedef struct plt_smooth_paint {
    plt_textures *textures;  /* NULL: there are none */
    plt_materials materials; /* which triangles have which */
    float angle;             /* side of a pixel, or sample, at a distance of 1 */
} plt_smooth_paint;

/* The colour of a point of triangle `id`, seen along `dir` at `t`: white, or what its corners have,
 * times its texel, if it has a texture. PLT_OK, or what the fetch of a tile failed with. */
int plt_smooth_paint_point(const plt_smooth_paint *paint, uint32_t id, const float dir[3], float t,
                           plt_surface_point *point);

#endif
#endif
