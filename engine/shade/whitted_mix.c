/* whitted_mix - see whitted_mix.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/whitted_mix.h"

#include "engine/shade/pixel_mix.h"
#include "engine/shade/whitted_frame.h"
#include "engine/whitted/lights.h"
#include "engine/whitted/point.h"
#include "engine/whitted/whitted.h"

#if PLT_WITH_WHITTED && PLT_WITH_SAMPLES

#define FINER 4u /* samples along a pixel's side, of those that are traced again */

static void mix(const plt_whitted *w, plt_sampling *s, uint32_t first, uint32_t bit,
                uint8_t rgb[3]) {
    plt_mix m;
    plt_mix_begin_pixel(s, &m);
    for (uint32_t i = first; i < first + (uint32_t)s->across * s->across; i++) {
        uint8_t colour[3];
        plt_whitted_frame_colour(&w->pixel[i], s->frame, colour);
        plt_mix_add(&m, colour, 1);
    }
    plt_mix_put(s, &m, bit, rgb);
}

void plt_whitted_mix(const plt_whitted *w, plt_sampling *s, const plt_pixels *pixels, uint8_t *rgb,
                     uint32_t row_bytes) {
    plt_mix_pixels k;
    plt_mix_pixels_set(&k, s, pixels);
    while (plt_mix_pixels_next(&k, s)) {
        mix(w, s, k.first, k.bit, &rgb[k.y * row_bytes + 3 * k.x]);
    }
}

/* ---- adaptive ---------------------------------------------------------------------- */

/* Pixels of the square in Z order, so that those of a packet are neighbours. */
static uint64_t bit_of(uint32_t place) {
    return (uint64_t)1 << (8 * plt_z_order_y(place) + plt_z_order_x(place));
}

/* The next place from `place` on that is one of some; there is one. */
static uint32_t next_of(uint64_t some, uint32_t place) {
    while ((some & bit_of(place)) == 0) {
        place++;
    }
    return place;
}

uint64_t plt_whitted_mix_some(const plt_whitted *w, const plt_sampling *s) {
    uint64_t some = 0;
    uint32_t rays = 0;
    for (uint32_t place = 0; place < 64 && rays < w->pixels; place++) {
        const uint64_t bit = s->mixed & bit_of(place);
        some |= bit;
        rays += bit != 0 ? FINER * FINER : 0;
    }
    return some;
}

/* Four samples of a pixel, from the sample at (x, y): a group of the packet. */
static void set_group(plt_whitted *w, plt_packet *packet, const plt_view *view, uint32_t first,
                      uint32_t x, uint32_t y) {
    _Alignas(16) float dir[3][4];
    f4 org[3], along[3];
    for (uint32_t i = 0; i < 4; i++) {
        float d[3];
        plt_view_direction(view, x + i % 2, y + i / 2, d);
        plt_whitted_pixel_set(w, first + i, d, plt_light_turn(x + i % 2, y + i / 2));
        for (int a = 0; a < 3; a++) {
            dir[a][i] = d[a];
        }
    }
    for (int a = 0; a < 3; a++) {
        org[a] = f4_all(view->eye[a]);
        along[a] = f4_load(dir[a]);
    }
    plt_packet_set_group(packet, first / 4, org, along, f4_zero(), f4_all(PLT_VIEW_FAR), 4);
}

static uint32_t rays_of(uint64_t some) {
    uint32_t rays = 0;
    for (; some != 0; some &= some - 1) {
        rays += FINER * FINER;
    }
    return rays;
}

void plt_whitted_mix_again(plt_whitted *w, plt_traversal *t, plt_packet *packet,
                           const plt_view *view, const plt_sampling *s, uint32_t x, uint32_t y) {
    const uint64_t some = plt_whitted_mix_some(w, s);
    const uint32_t rays = rays_of(some);
    plt_packet_begin(packet, w->box, rays / 4, 0);
    plt_point_want(t->scene, packet);
    for (uint32_t k = 0, place = 0; k < rays; place++) {
        place = next_of(some, place);
        const uint32_t first_x = FINER * (x + plt_z_order_x(place));
        const uint32_t first_y = FINER * (y + plt_z_order_y(place));
        for (uint32_t i = 0; i < FINER * FINER; i += 4, k += 4) {
            set_group(w, packet, view, k, first_x + plt_z_order_x(i), first_y + plt_z_order_y(i));
        }
    }
    for (uint32_t k = rays; k < w->pixels; k++) {
        plt_whitted_pixel_none(w, k);
    }
    plt_packet_finish(packet);
    plt_traversal_begin(t, packet, rays);
    plt_whitted_begin(w, packet, rays);
}

void plt_whitted_mix_finer(const plt_whitted *w, plt_sampling *s, uint8_t *rgb,
                           uint32_t row_bytes) {
    const uint64_t some = plt_whitted_mix_some(w, s);
    const uint32_t rays = rays_of(some);
    for (uint32_t k = 0, place = 0; k < rays; k += FINER * FINER, place++) {
        place = next_of(some, place);
        const uint32_t x = plt_z_order_x(place), y = plt_z_order_y(place);
        mix(w, s, k, 8 * y + x, &rgb[y * row_bytes + 3 * x]);
    }
}

#endif
