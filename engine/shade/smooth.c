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
#include "engine/shade/pixel_mix.h"
#include "engine/shade/surface.h"
#include "engine/trace/surface_hit.h"

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

static int shade_lane(const plt_smooth *how, const plt_packet *p, uint32_t ray, shaded *s,
                      uint8_t rgb[3]) {
    const plt_group_rays *g = &p->rays[ray / 4];
    const unsigned lane = ray % 4;
    const float dir[3] = {g->dir[0][lane], g->dir[1][lane], g->dir[2][lane]};
    plt_surface_point point;
    if (g->id[lane] != s->id) {
        const int status = plt_surface_of_ray(how->traversal, p, ray, &s->corners);
        if (status != PLT_OK) {
            return status;
        }
        s->id = g->id[lane];
    }
    plt_surface_mix(&s->corners, g->u[lane], g->v[lane], &point);
    return plt_smooth_point(how, s->id, dir, p->slabs.group[ray / 4].tmax[lane], &point, rgb);
}

/* Of ray k. */
static int shade_ray(const plt_smooth *how, const plt_packet *p, uint32_t k, const uint8_t sky[3],
                     shaded *s, uint8_t rgb[3]) {
    const plt_group_rays *g = &p->rays[k / 4];
    if (p->active == 0 || !(g->valid >> k % 4 & 1u) || g->id[k % 4] == PLT_MISS) {
        memcpy(rgb, sky, 3);
        return PLT_OK;
    }
    return shade_lane(how, p, k, s, rgb);
}

int plt_smooth_shade(const plt_smooth *how, const plt_packet *p, const plt_pixels *pixels,
                     const uint8_t *sky, uint8_t *rgb, uint32_t row_bytes) {
    const uint32_t columns = pixels->x_end - pixels->x, rows = pixels->y_end - pixels->y;
    shaded s = {.id = PLT_MISS};
    int status = PLT_OK;
    for (uint32_t k = 0; k < pixels->side * pixels->side && status == PLT_OK; k++) {
        const uint32_t x = plt_z_order_x(k), y = plt_z_order_y(k);
        if (x < columns && y < rows) {
            status = shade_ray(how, p, k, &sky[3 * y], &s, &rgb[y * row_bytes + 3 * x]);
        }
    }
    return status;
}

#if PLT_WITH_SAMPLES
int plt_smooth_mix(const plt_smooth *how, const plt_packet *p, plt_sampling *s,
                   const plt_pixels *pixels, const uint8_t *sky, uint8_t *rgb, uint32_t row_bytes) {
    shaded last = {.id = PLT_MISS};
    plt_mix_pixels k;
    plt_mix_pixels_set(&k, s, pixels);
    while (plt_mix_pixels_next(&k, s)) {
        plt_mix m;
        plt_mix_begin_pixel(s, &m);
        for (uint32_t i = 0; i < k.rays; i++) {
            uint8_t colour[3];
            const int status = shade_ray(how, p, k.first + i, &sky[3 * k.y], &last, colour);
            if (status != PLT_OK) {
                return status;
            }
            plt_mix_add(&m, colour, 1);
        }
        plt_mix_put(s, &m, k.bit, &rgb[k.y * row_bytes + 3 * k.x]);
    }
    return PLT_OK;
}
#endif

#endif
#endif
