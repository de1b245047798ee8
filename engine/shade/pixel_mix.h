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

static inline void plt_mix_put(plt_sampling *s, const plt_mix *m, uint32_t bit, uint8_t rgb[3]) {
    if (s->across == 2 && s->adapts && plt_mix_differs(m)) {
        s->mixed |= (uint64_t)1 << bit;
    }
    plt_mix_get(m, (uint32_t)s->across * s->across, rgb);
}

#endif
