/* smooth - see smooth.h
 *
 * Source of the idea, normals weighted over a triangle: B. T. Phong, Illumination for Computer
 * Generated Pictures, 1975.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/smooth.h"

#if PLT_WITH_SURFACE

#include <string.h>

#include "engine/scene/surface_place.h"
#include "engine/shade/pixel_mix.h"
#include "engine/shade/surface.h"
#include "engine/surface/surface_corners.h"

static float dot(const float a[3], const float b[3]) {
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

/* The largest component is 1 then: squares neither vanish nor overflow. */
static void even_out(const float v[3], float to[3]) {
    const float x = __builtin_fabsf(v[0]), y = __builtin_fabsf(v[1]), z = __builtin_fabsf(v[2]);
    const float xy = x > y ? x : y, most = xy > z ? xy : z;
    for (int a = 0; a < 3; a++) {
        to[a] = v[a] / most;
    }
}

void plt_smooth_colour(const plt_surface_point *p, const float dir[3], uint8_t rgb[3]) {
    static const float clay[3] = {PLT_CLAY_RED, PLT_CLAY_GREEN, PLT_CLAY_BLUE};
    const float squared = dot(p->normal, p->normal);
    float d[3], facing = 1.0f;
    even_out(dir, d);
    if (squared > 0.0f) { /* else a sliver: as if it faced the eye */
        const float along = dot(p->normal, d);
        facing = __builtin_sqrtf(along * along / (squared * dot(d, d)));
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

/* Of ray k. */
static void shade_ray(const plt_scene *scene, const plt_packet *p, uint32_t k, const uint8_t sky[3],
                      shaded *s, uint8_t rgb[3]) {
    const plt_group_rays *g = &p->rays[k / 4];
    if (p->active == 0 || !(g->valid >> k % 4 & 1u) || g->id[k % 4] == PLT_MISS) {
        memcpy(rgb, sky, 3);
    } else {
        shade_lane(scene, g, k % 4, s, rgb);
    }
}

void plt_smooth_shade(const plt_scene *scene, const plt_packet *p, const plt_pixels *pixels,
                      const uint8_t *sky, uint8_t *rgb, uint32_t row_bytes) {
    const uint32_t columns = pixels->x_end - pixels->x, rows = pixels->y_end - pixels->y;
    shaded s = {.id = PLT_MISS};
    for (uint32_t k = 0; k < pixels->side * pixels->side; k++) {
        const uint32_t x = plt_z_order_x(k), y = plt_z_order_y(k);
        if (x < columns && y < rows) {
            shade_ray(scene, p, k, &sky[3 * y], &s, &rgb[y * row_bytes + 3 * x]);
        }
    }
}

#if PLT_WITH_SAMPLES
void plt_smooth_mix(const plt_scene *scene, const plt_packet *p, plt_sampling *s,
                    const plt_pixels *pixels, const uint8_t *sky, uint8_t *rgb,
                    uint32_t row_bytes) {
    shaded last = {.id = PLT_MISS};
    plt_mix_pixels k;
    plt_mix_pixels_set(&k, s, pixels);
    while (plt_mix_pixels_next(&k, s)) {
        plt_mix m;
        plt_mix_begin(&m);
        for (uint32_t i = 0; i < k.rays; i++) {
            uint8_t colour[3];
            shade_ray(scene, p, k.first + i, &sky[3 * k.y], &last, colour);
            plt_mix_add(&m, colour, 1);
        }
        plt_mix_put(s, &m, k.bit, &rgb[k.y * row_bytes + 3 * k.x]);
    }
}
#endif

#endif
#endif
