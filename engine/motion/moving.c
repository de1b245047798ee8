/* moving - see moving.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/moving.h"

/* Rounded once: a 64-bit conversion would be a function of the compiler's. */
static float float_of(uint64_t x) {
    return (float)(uint32_t)(x >> 32) * 4294967296.0f + (float)(uint32_t)x;
}

static float change_of(uint64_t now, uint64_t built) {
    const uint64_t change = now >= built ? now - built : built - now;
    const float size = built == 0 ? 0.0f : float_of(change) / float_of(built);
    return now >= built ? size : -size;
}

float plt_degradation(const plt_moving *m) {
    return change_of(m->areas.ratios, m->areas_built.ratios);
}

float plt_growth(const plt_moving *m) {
    return change_of(m->areas.sum, m->areas_built.sum);
}

#if PLT_WITH_REBUILD
/* Excess is a share of the work that was done, in 1/65,536. */
void plt_moving_count(plt_moving *m, uint64_t work) {
    const float worse = 0.01f * (float)PLT_GROWTH_WORK * plt_growth(m);
    if (worse > 0.0f) {
        const float share = worse / (1.0f + worse);
        m->excess += (work * (uint32_t)(int32_t)(share * 65536.0f)) >> 16;
    }
}
#endif
