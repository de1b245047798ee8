/* samples - the mean of colours in linear light, sought among all bytes
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_SAMPLES_H
#define REFERENCE_SAMPLES_H

#include <stdlib.h>

#include "engine/shade/light.h"

/* The byte whose light is nearest to light / samples, the greater of two, among all. */
static inline int samples_byte(int64_t light, int64_t samples) {
    int best = 0;
    for (int b = 1; b < 256; b++) {
        if (llabs(samples * plt_linear[b] - light) <= llabs(samples * plt_linear[best] - light)) {
            best = b;
        }
    }
    return best;
}

/* Of so many colours, one after another. */
static inline void samples_mean(uint32_t samples, const uint8_t (*of)[3], uint8_t rgb[3]) {
    for (int c = 0; c < 3; c++) {
        int64_t light = 0;
        for (uint32_t i = 0; i < samples; i++) {
            light += plt_linear[of[i][c]];
        }
        rgb[c] = (uint8_t)samples_byte(light, samples);
    }
}

#endif
