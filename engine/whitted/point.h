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

/* Sets normal, side and tint of a pixel whose ray, of length 1, has hit in that lane. Seen from
 * its side, the normal never faces away. Where there may be textures, *surface is what it is of. */
#if PLT_WITH_TEXTURE
void plt_point_set(const plt_scene *scene, plt_lit_pixel *pixel, const plt_group_rays *group,
                   unsigned lane, plt_surface_point *surface);
#else
void plt_point_set(const plt_scene *scene, plt_lit_pixel *pixel, const plt_group_rays *group,
                   unsigned lane);
#endif

#endif
