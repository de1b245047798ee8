/* packet_mix - the colours of a packet of samples, and of distances
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/packet_mix.h"

#include <string.h>

#include "engine/shade/pixel_mix.h"
#include "engine/shade/surface.h"

#if PLT_WITH_GROUPS && (PLT_WITH_SAMPLES || PLT_WITH_DIAGRAMS)

/* A pixel: its first ray, and the direction through its middle. */
typedef struct place {
    const plt_packet *p;
    uint32_t first;
    float dir[3];
    const uint8_t *sky;
} place;

static int has_depths(const plt_sampling *s) {
    return PLT_WITH_DIAGRAMS && s->frame->shader == PLT_SHADE_DEPTH;
}

/* Nothing is set in a packet that meets nothing. */
static uint32_t id_of(const plt_packet *p, uint32_t ray) {
    const plt_group_rays *g = &p->rays[ray / 4];
    return p->active == 0 || !(g->valid >> ray % 4 & 1u) ? PLT_MISS : g->id[ray % 4];
}

static void vector_of(const float from[3][4], uint32_t ray, float to[3]) {
    for (int a = 0; a < 3; a++) {
        to[a] = from[a][ray % 4];
    }
}

static void colour_of(const place *at, const plt_sampling *s, uint32_t ray, uint8_t rgb[3]) {
    const plt_group_rays *g = &at->p->rays[ray / 4];
    const uint32_t id = id_of(at->p, ray);
    float v[3];
    if (id == PLT_MISS) {
        if (has_depths(s)) {
            memset(rgb, 0, 3);
        } else {
            memcpy(rgb, at->sky, 3);
        }
        return;
    }
#if PLT_WITH_DIAGRAMS
    if (has_depths(s)) {
        vector_of(g->dir, ray, v);
        plt_depth_colour(&s->depths, v, at->p->slabs.group[ray / 4].tmax[ray % 4], rgb);
        return;
    }
#endif
    plt_surface surface;
    vector_of(g->normal, ray, v);
    plt_surface_set(&surface, v);
    plt_surface_colour(&surface, s->frame->shader, id, at->dir, rgb);
}

#if PLT_WITH_SAMPLES
/* Two rays of a pixel have the same colour for sure. */
static int are_alike(const plt_packet *p, uint32_t a, uint32_t b) {
    float n[3], o[3];
    if (id_of(p, a) != id_of(p, b)) {
        return 0;
    }
    if (id_of(p, a) == PLT_MISS) {
        return 1;
    }
    vector_of(p->rays[a / 4].normal, a, n);
    vector_of(p->rays[b / 4].normal, b, o);
    return n[0] == o[0] && n[1] == o[1] && n[2] == o[2];
}

static int is_whole(const place *at, uint32_t rays) {
    for (uint32_t i = 1; i < rays; i++) {
        if (!are_alike(at->p, at->first, at->first + i)) {
            return 0;
        }
    }
    return 1;
}

static void mix(const place *at, plt_sampling *s, uint32_t rays, uint32_t bit, uint8_t rgb[3]) {
    uint8_t colour[3];
    plt_mix m;
    plt_mix_begin_pixel(s, &m);
    for (uint32_t i = at->first; i < at->first + rays; i++) {
        if (i == at->first || has_depths(s) || !are_alike(at->p, i - 1, i)) {
            colour_of(at, s, i, colour);
        }
        plt_mix_add(&m, colour, 1);
    }
    plt_mix_put(s, &m, bit, rgb);
}
#endif

static void shade(const place *at, plt_sampling *s, uint32_t rays, uint32_t bit, uint8_t rgb[3]) {
#if PLT_WITH_SAMPLES
    if (rays > 1 && (has_depths(s) || !is_whole(at, rays))) {
        mix(at, s, rays, bit, rgb);
        return;
    }
#endif
    (void)rays;
    (void)bit;
    colour_of(at, s, at->first, rgb);
}

void plt_packet_mix(const plt_packet *p, plt_sampling *s, const plt_pixels *pixels,
                    const uint8_t *sky, uint8_t *rgb, uint32_t row_bytes) {
    const uint32_t first_x = pixels->x / s->across, first_y = pixels->y / s->across;
    plt_mix_pixels k;
    plt_mix_pixels_set(&k, s, pixels);
    while (plt_mix_pixels_next(&k, s)) {
        place at = {.p = p, .first = k.first, .sky = &sky[3 * k.y]};
        plt_view_direction(&s->middle, first_x + k.x, first_y + k.y, at.dir);
        shade(&at, s, k.rays, k.bit, &rgb[k.y * row_bytes + 3 * k.x]);
    }
}

#endif
