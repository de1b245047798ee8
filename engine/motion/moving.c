/* moving - see moving.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/moving.h"

/* Rounded once: a 64-bit conversion would be a function of the compiler's. */
static float float_of(uint64_t x) {
    return (float)(uint32_t)(x >> 32) * 4294967296.0f + (float)(uint32_t)x;
}

float plt_degradation(const plt_moving *m) {
    const int grown = m->spread >= m->spread_built;
    const uint64_t change = grown ? m->spread - m->spread_built : m->spread_built - m->spread;
    if (m->spread_built == 0) {
        return 0.0f;
    }
    const float size = float_of(change) / float_of(m->spread_built);
    return grown ? size : -size;
}

#if PLT_WITH_REBUILD
/* Excess is a share of the work that was done, in 1/65,536. */
void plt_moving_count(plt_moving *m, uint64_t work) {
    const float worse = (float)PLT_DEGRADATION_WORK * plt_degradation(m);
    if (worse > 0.0f) {
        const float share = worse / (1.0f + worse);
        m->excess += (work * (uint32_t)(int32_t)(share * 65536.0f)) >> 16;
    }
}
#endif
