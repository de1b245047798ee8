/* point - the surface where a ray has hit: normals, and the colour of its corners
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WHITTED_POINT_H
#define PLT_WHITTED_POINT_H

#include "engine/whitted/state.h"

/* Hits of the scene are to have u and v; else normals. */
int plt_point_is_smooth(const plt_scene *scene);

/* Before plt_traversal_begin, of rays that seek the nearest hit: what its hits are to have. */
void plt_point_want(const plt_scene *scene, plt_packet *packet);

/* Sets normal, side and tint of a pixel whose ray, of length 1, is that of the packet, and has hit.
 * Seen from its side, the normal never faces away. Where there may be textures, *surface is what it
 * is of. PLT_OK, or what a fetch failed with. */
#if PLT_WITH_TEXTURE
int plt_point_set(plt_traversal *t, plt_lit_pixel *pixel, const plt_packet *packet, uint32_t ray,
                  plt_surface_point *surface);
#else
int plt_point_set(plt_traversal *t, plt_lit_pixel *pixel, const plt_packet *packet, uint32_t ray);
#endif

#endif
