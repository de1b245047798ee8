/* lane - one lane of four that lie in memory, in their order (lanes.h)
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_LANES_LANE_H
#define PLT_LANES_LANE_H

#include <string.h>

#include "engine/lanes/lanes.h"

static inline float plt_lane(const f4 *v, unsigned lane) {
    float x;
    memcpy(&x, (const char *)v + lane * sizeof x, sizeof x);
    return x;
}

static inline void plt_lane_set(f4 *v, unsigned lane, float to) {
    memcpy((char *)v + lane * sizeof to, &to, sizeof to);
}

#endif
