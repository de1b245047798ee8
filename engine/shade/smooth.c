/* smooth - see smooth.h
 *
 * Source of the idea, normals weighted over a triangle: B. T. Phong, Illumination for Computer
 * Generated Pictures, 1975.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/smooth.h"

#if PLT_WITH_SURFACE

#include <string.h>

#include "engine/base/vector.h"
#include "engine/scene/surface_place.h"
#include "engine/shade/surface.h"
#include "engine/surface/surface_corners.h"

void plt_smooth_colour(const plt_surface_point *p, const float dir[3], uint8_t rgb[3]) {
    static const float clay[3] = {PLT_CLAY_RED, PLT_CLAY_GREEN, PLT_CLAY_BLUE};
    const float squared = plt_dot(p->normal, p->normal);
    float d[3] = {dir[0], dir[1], dir[2]}, facing = 1.0f;
    plt_even_out(d);
    if (squared > 0.0f) { /* else a sliver: as if it faced the eye */
        const float along = plt_dot(p->normal, d);
        facing = __builtin_sqrtf(along * along / (squared * plt_dot(d, d)));
        facing = facing < 1.0f ? facing : 1.0f;
    }
    for (int c = 0; c < 3; c++) {
        const float colour = p->has_colour ? p->colour[c] : clay[c];
        rgb[c] = (uint8_t)(int32_t)(facing * colour * 255.0f + 0.5f);
    }
}

#if PLT_WITH_GROUPS

/* Corners of the triangle that was shaded last. */
typedef struct shaded {
    uint32_t id;
    plt_surface_corners corners;
} shaded;

static void shade_lane(const plt_scene *scene, const plt_group_rays *g, unsigned lane, shaded *s,
                       uint8_t rgb[3]) {
    plt_record room;
    const float dir[3] = {g->dir[0][lane], g->dir[1][lane], g->dir[2][lane]};
    plt_surface_point point;
    if (g->id[lane] != s->id) {
        s->id = g->id[lane];
        plt_surface_corners_set(&s->corners, &scene->surface,
                                plt_surface_record(scene, s->id, &room));
    }
    plt_surface_mix(&s->corners, g->u[lane], g->v[lane], &point);
    plt_smooth_colour(&point, dir, rgb);
}

void plt_smooth_shade(const plt_scene *scene, const plt_packet *p, const plt_pixels *pixels,
                      const uint8_t *sky, uint8_t *rgb, uint32_t row_bytes) {
    const uint32_t columns = pixels->x_end - pixels->x, rows = pixels->y_end - pixels->y;
    shaded s = {.id = PLT_MISS};
    for (uint32_t k = 0; k < pixels->side * pixels->side; k++) {
        const uint32_t x = plt_z_order_x(k), y = plt_z_order_y(k);
        const plt_group_rays *g = &p->rays[k / 4];
        if (x >= columns || y >= rows) {
            continue;
        }
        uint8_t *to = &rgb[y * row_bytes + 3 * x];
        if (p->active == 0 || !(g->valid >> k % 4 & 1u) || g->id[k % 4] == PLT_MISS) {
            memcpy(to, &sky[3 * y], 3);
        } else {
            shade_lane(scene, g, k % 4, &s, to);
        }
    }
}

#endif
#endif
