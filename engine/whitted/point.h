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

/* Sets normal, side and tint of a pixel whose ray, of length 1, has hit in that lane, and whose
 * material is set. Seen from its side, the normal never faces away. PLT_OK, or what the fetch of a
 * tile failed with. */
int plt_point_set(const plt_whitted *w, const plt_scene *scene, plt_lit_pixel *pixel,
                  const plt_group_rays *group, unsigned lane);

#endif
