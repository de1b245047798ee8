/* smooth_paint - see smooth_paint.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/smooth_paint.h"

#if PLT_WITH_TEXTURE

#include "engine/base/vector.h"
#include "engine/texture/tint.h"

/* Of a triangle without area, whose `flat` is 0, the longest pixels that there are. */
static float area_of(const plt_smooth_paint *s, const float dir[3], float t,
                     const plt_surface_point *point) {
    float d[3] = {dir[0], dir[1], dir[2]};
    const float most = plt_even_out(d), length = __builtin_sqrtf(plt_dot(d, d));
    const float cosine = __builtin_fabsf(plt_dot(d, point->flat)) / length;
    return plt_texture_area(t * (most * length) * s->angle, point->texcoord_scale, cosine);
}

int plt_smooth_paint_point(const plt_smooth_paint *s, uint32_t id, const float dir[3], float t,
                           plt_surface_point *point) {
    uint8_t rgb[3];
    if (s->textures == NULL || !point->has_texcoord) {
        return PLT_OK;
    }
    const uint32_t material = plt_materials_find(&s->materials, id);
    if (!plt_texture_is_there(s->textures, material)) {
        return PLT_OK;
    }
    for (int c = 0; c < 3; c++) { /* of a point without a colour it is 1 */
        rgb[c] = (uint8_t)(int32_t)(point->colour[c] * 255.0f + 0.5f);
    }
    const int status =
        plt_texture_tint(s->textures, material, point->texcoord, area_of(s, dir, t, point), rgb);
    for (int c = 0; c < 3 && status == PLT_OK; c++) {
        point->colour[c] = (float)rgb[c] / 255.0f;
    }
    point->has_colour = 1;
    return status;
}

#endif
