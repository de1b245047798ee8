/* light - see light.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/light.h"

#if PLT_WITH_SAMPLES

#define NEAR 8 /* bytes */

/* Light grows with the byte, and faster and faster: so the byte is not below the mean of those that
 * were added, and mostly close to it; else it is found by halves. (The table is off by a half, and
 * its numbers are 19 apart at least.) */
static uint8_t byte_of(uint32_t light, uint32_t samples, uint32_t total) {
    const uint32_t twice = 2 * light / samples;
    uint32_t byte = total / samples, most = byte + NEAR < 255 ? byte + NEAR : 255;
    while (byte < most && twice >= (uint32_t)plt_linear[byte] + plt_linear[byte + 1]) {
        byte++;
    }
    if (byte < most) {
        return (uint8_t)byte;
    }
    for (most = 255; byte < most;) {
        const uint32_t middle = (byte + most) / 2;
        if (twice >= (uint32_t)plt_linear[middle] + plt_linear[middle + 1]) {
            byte = middle + 1;
        } else {
            most = middle;
        }
    }
    return (uint8_t)byte;
}

void plt_mix_get(const plt_mix *m, uint32_t samples, uint8_t rgb[3]) {
    for (int c = 0; c < 3; c++) {
        rgb[c] = byte_of(m->light[c], samples, m->total[c]);
    }
}

#endif
