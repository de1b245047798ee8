/* direct - light that comes straight from lights, and from all around
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WHITTED_DIRECT_H
#define PLT_WHITTED_DIRECT_H

#include "engine/whitted/state.h"

/* What a hit has of its own: emission, and of what is around it the sky above and the ground
 * below. Sets is_lit. */
void plt_direct_begin(plt_whitted *w, plt_lit_pixel *pixel);

/* The pixels that the current sample of the current light may reach go into `slot`; returns how
 * many. */
uint32_t plt_direct_find(plt_whitted *w);

/* The shadow ray of one of them; returns its tmax. */
float plt_direct_ray(const plt_whitted *w, const plt_lit_pixel *pixel, float org[3], float dir[3]);

/* Adds the light of the sample that reaches a hit: the share `through` of it. */
void plt_direct_add(const plt_whitted *w, plt_lit_pixel *pixel, const float through[3]);

/* The rays, of any hit, are traced: adds the light of those that nothing was in the way of. */
void plt_direct_take(plt_whitted *w, const plt_packet *packet);

/* Of what an opaque mirror reflects, red, green and blue; 0 of others. */
void plt_direct_mirror(const plt_material *material, const plt_lit_pixel *pixel, float to[3]);

#endif
