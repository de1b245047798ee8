/* levels - how deep a tree must be at least
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BUILDER_LEVELS_H
#define PLT_BUILDER_LEVELS_H

#include <stdint.h>

/* Levels that halving by number takes until lists hold at most `most`. */
static inline uint32_t plt_levels_needed(uint32_t count, uint32_t most) {
    uint32_t levels = 0;
    for (; count > most; count -= count / 2) {
        levels++;
    }
    return levels;
}

#endif
