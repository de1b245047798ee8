/* paint - the texture of a surface where a ray has hit
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WHITTED_PAINT_H
#define PLT_WHITTED_PAINT_H

#include "engine/whitted/state.h"

#if PLT_WITH_TEXTURE
/* A ray has hit along `dir`, at `t`: how far the point is from the eye, as its light goes. */
void plt_paint_far(plt_lit_ray *ray, const plt_group_rays *group, unsigned lane, float t);

/* The tint of a pixel, times the texel of its material's texture, if there is one. PLT_OK, or what
 * the fetch of a tile failed with. */
int plt_paint_point(const plt_whitted *w, plt_lit_pixel *pixel, const plt_surface_point *point);
#else
static inline void plt_paint_far(plt_lit_ray *ray, const plt_group_rays *group, unsigned lane,
                                 float t) {
    (void)ray;
    (void)group;
    (void)lane;
    (void)t;
}

static inline int plt_paint_point(const plt_whitted *w, plt_lit_pixel *pixel,
                                  const plt_surface_point *point) {
    (void)w;
    (void)pixel;
    (void)point;
    return PLT_OK;
}
#endif

#endif
