/* paint - the texture of a surface where a ray has hit
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WHITTED_PAINT_H
#define PLT_WHITTED_PAINT_H

#include "engine/whitted/state.h"

#if PLT_WITH_TEXTURE
/* A ray has hit along `dir`, at `t`: how far the point is from the eye, as its light goes. */
void plt_paint_far(plt_lit_ray *ray, const plt_group_rays *group, unsigned lane, float t);

/* The tint of a pixel whose material is set, times the texel of its texture, if there is one. Sets
 * w->failed to what the fetch of a tile fails with. */
void plt_paint_point(plt_whitted *w, plt_lit_pixel *pixel, const plt_surface_point *point);
#endif

/* PLT_MORE, or what a fetch has failed with since the frame began. */
static inline int plt_paint_status(const plt_whitted *w) {
#if PLT_WITH_TEXTURE
    return w->failed < PLT_OK ? w->failed : PLT_MORE;
#else
    (void)w;
    return PLT_MORE;
#endif
}

#endif
