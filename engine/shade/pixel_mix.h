/* pixel_mix - which pixels of a square are shaded anew, and which of them are mixed
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_PIXEL_MIX_H
#define PLT_SHADE_PIXEL_MIX_H

#include "engine/shade/light.h"
#include "engine/shade/sampling.h"

/* Pixel (x, y) of what is traced in plt_sampling.mixed. */
static inline uint32_t plt_mixed_bit(const plt_sampling *s, uint32_t x, uint32_t y) {
    return 8 * (y + s->y) + x + s->x;
}

/* Whether its colour is wanted. */
static inline int plt_is_shaded(const plt_sampling *s, uint32_t bit) {
    return s->columns == 0 || (s->mixed >> bit & 1u) != 0;
}

/* The pixels of a packet of samples that lie in the frame and whose colour is wanted, one after
 * another. Rays are in Z order, so those of a pixel follow each other: `rays` from `first`. */
typedef struct plt_mix_pixels {
    uint32_t next, end, columns, rows;
    uint32_t first, rays, x, y, bit;
} plt_mix_pixels;

static inline void plt_mix_pixels_set(plt_mix_pixels *p, const plt_sampling *s,
                                      const plt_pixels *pixels) {
    const uint32_t across = s->across, side = pixels->side / across;
    p->next = 0;
    p->end = side * side;
    p->rays = across * across;
    p->columns = pixels->x_end / across - pixels->x / across;
    p->rows = pixels->y_end / across - pixels->y / across;
}

/* To the next one; 0: there is none. */
static inline int plt_mix_pixels_next(plt_mix_pixels *p, const plt_sampling *s) {
    while (p->next < p->end) {
        const uint32_t k = p->next++;
        p->first = p->rays * k;
        p->x = plt_z_order_x(k);
        p->y = plt_z_order_y(k);
        p->bit = plt_mixed_bit(s, p->x, p->y);
        if (p->x < p->columns && p->y < p->rows && plt_is_shaded(s, p->bit)) {
            return 1;
        }
    }
    return 0;
}

/* Of the samples of a pixel. */
static inline void plt_mix_begin_pixel(const plt_sampling *s, plt_mix *m) {
    plt_mix_begin(m, s->across == 2 && s->adapts);
}

static inline void plt_mix_put(plt_sampling *s, const plt_mix *m, uint32_t bit, uint8_t rgb[3]) {
    if (m->compares && plt_mix_differs(m)) {
        s->mixed |= (uint64_t)1 << bit;
    }
    plt_mix_get(m, (uint32_t)s->across * s->across, rgb);
}

#endif
