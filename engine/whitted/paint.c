/* paint - see paint.h
 *
 * A pixel is as wide as its angle times the way that its light goes, off mirrors and through glass,
 * too, as if those were flat. On a surface that is tilted it is longer; of both sides the mean
 * chooses the level of a texture.
 *
 * Source of the idea: J. Amanatides, "Ray tracing with cones", 1984.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/whitted/paint.h"

#if PLT_WITH_TEXTURE

#include "engine/base/linear.h"
#include "engine/whitted/optics.h"
#include "engine/whitted/srgb.h"

#define TILT_LEAST 0.015625f /* a cosine of 1/64: a surface seen edge on is not all that long */

void plt_paint_far(plt_lit_ray *ray, const plt_group_rays *g, unsigned lane, float t) {
    const float dir[3] = {g->dir[0][lane], g->dir[1][lane], g->dir[2][lane]};
    ray->before += t * __builtin_sqrtf(plt_optics_dot(dir, dir));
}

/* Texture coordinates that the pixel covers, as an area. */
static float area_of(const plt_whitted *w, const plt_lit_pixel *p, const plt_surface_point *point) {
    const float cosine = -plt_optics_dot(p->ray.dir, p->side);
    const float across = p->ray.before * w->angle * point->texcoord_scale;
    return across * across / (cosine > TILT_LEAST ? cosine : TILT_LEAST);
}

void plt_paint_point(plt_whitted *w, plt_lit_pixel *p, const plt_surface_point *point) {
    float texel[3];
    if (w->textures == NULL || !point->has_texcoord || w->failed < PLT_OK) {
        return;
    }
    w->failed =
        plt_texture_sample(w->textures, p->material, point->texcoord, area_of(w, p, point), texel);
    for (int c = 0; c < 3 && w->failed == PLT_OK; c++) {
        const float tint = (float)plt_linear[p->tint[c]] / 65535.0f;
        p->tint[c] = plt_srgb_byte(tint * texel[c]);
    }
}

#endif
