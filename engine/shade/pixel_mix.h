/* pixel_mix - which pixels of a square are shaded anew, and which of them are mixed
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_PIXEL_MIX_H
#define PLT_SHADE_PIXEL_MIX_H

#include "engine/shade/light.h"
#include "engine/shade/sampling.h"

/* Pixel (x, y) of the square in plt_sampling.mixed; of a quarter that is traced again, 4 x 4 pixels
 * at most, where that lies. */
static inline uint32_t plt_mixed_bit(const plt_sampling *s, uint32_t side, uint32_t x, uint32_t y) {
    const uint32_t quarter = s->across == 4 && s->adapts ? side / 4 : 0;
    return 8 * (y + (s->part >> 1) * quarter) + x + (s->part & 1u) * quarter;
}

/* Whether its colour is wanted. */
static inline int plt_is_shaded(const plt_sampling *s, uint32_t bit) {
    return s->across != 4 || !s->adapts || (s->mixed >> bit & 1u) != 0;
}

/* The pixels of a packet of samples that lie in the frame and whose colour is wanted, one after
 * another. Rays are in Z order, so those of a pixel follow each other: `rays` from `first`. */
typedef struct plt_mix_pixels {
    uint32_t next, end, side, columns, rows;
    uint32_t first, rays, x, y, bit;
} plt_mix_pixels;

static inline void plt_mix_pixels_set(plt_mix_pixels *p, const plt_sampling *s,
                                      const plt_pixels *pixels) {
    const uint32_t across = s->across, side = pixels->side / across;
    p->next = 0;
    p->end = side * side;
    p->side = pixels->side;
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
        p->bit = plt_mixed_bit(s, p->side, p->x, p->y);
        if (p->x < p->columns && p->y < p->rows && plt_is_shaded(s, p->bit)) {
            return 1;
        }
    }
    return 0;
}

static inline void plt_mix_put(plt_sampling *s, const plt_mix *m, uint32_t bit, uint8_t rgb[3]) {
    if (s->across == 2 && s->adapts && plt_mix_differs(m)) {
        s->mixed |= (uint64_t)1 << bit;
    }
    plt_mix_get(m, (uint32_t)s->across * s->across, rgb);
}

#endif
