/* diagram - pictures of distances and of node visits
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_DIAGRAM_H
#define PLT_SHADE_DIAGRAM_H

#include "engine/base/box.h"
#include "engine/planelet.h"

/* Distances from the eye to the nearest point of the scene's box, 0 if that is around it, and to
 * its farthest corner. */
typedef struct plt_depths {
    float nearest, farthest;
} plt_depths;

void plt_depths_set(plt_depths *d, const plt_box *scene, const float eye[3]);

/* A hit at t along `dir`: white at the nearest distance, black at the farthest, linear in between
 * (and in bytes, as what sRGB makes of them is even to the eye). */
void plt_depth_colour(const plt_depths *d, const float dir[3], float t, uint8_t rgb[3]);

/* `visits` of a packet of `pixels`: see PLT_HEAT_LEVELS. */
void plt_heat_colour(uint64_t visits, uint32_t pixels, uint8_t rgb[3]);

#endif
