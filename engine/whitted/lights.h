/* lights - where light comes from, seen from a point
 *
 * A light with a radius is a disc that faces the point; its samples lie on a spiral of Vogel's
 * (1979), which is turned by one of 16 angles from pixel to pixel, so that the edge of a soft
 * shadow is grain and not steps. No libm: angles are a table.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WHITTED_LIGHTS_H
#define PLT_WHITTED_LIGHTS_H

#include "engine/planelet.h"

/* All numbers are in their ranges (plt_lighting_set). */
int plt_lighting_valid(const plt_lighting *lighting);

/* The angle of a pixel: neighbours have others, an order of Bayer's. */
uint8_t plt_light_turn(uint32_t x, uint32_t y);

/* From `point` to sample `sample` of the light, of any length; of a distant one the direction.
 * Returns how bright a white surface is that faces it, as a factor of its power: 0: it has no
 * direction there. */
float plt_light_towards(const plt_light *light, unsigned sample, uint8_t turn, const float point[3],
                        float to[3]);

/* Where nothing is hit: sky above, ground below, along a direction of length 1. */
void plt_light_sky(const plt_lighting *lighting, float up, float to[3]);

#endif
