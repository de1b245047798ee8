/* paint - see paint.h
 *
 * A pixel is as wide as its angle times the way that its light goes, off mirrors and through glass,
 * too, as if those were flat (texture/tint.h has how long it is on a surface that is tilted).
 *
 * Source of the idea: J. Amanatides, "Ray tracing with cones", 1984.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/whitted/paint.h"

#if PLT_WITH_TEXTURE && PLT_WITH_WHITTED

#include "engine/texture/tint.h"
#include "engine/whitted/optics.h"

void plt_paint_far(plt_lit_ray *ray, const plt_group_rays *g, unsigned lane, float t) {
    const float dir[3] = {g->dir[0][lane], g->dir[1][lane], g->dir[2][lane]};
    ray->before += t * __builtin_sqrtf(plt_optics_dot(dir, dir));
}

void plt_paint_point(plt_whitted *w, plt_lit_pixel *p, const plt_surface_point *point) {
    if (w->textures == NULL || !point->has_texcoord || w->failed < PLT_OK) {
        return;
    }
    const float area = plt_texture_area(p->ray.before * w->angle, point->texcoord_scale,
                                        -plt_optics_dot(p->ray.dir, p->side));
    w->failed = plt_texture_tint(w->textures, p->material, point->texcoord, area, p->tint);
}

#endif
