/* light - see light.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/light.h"

#if PLT_WITH_SAMPLES

/* Light grows with the byte, and faster than it: so the byte is between the least and the greatest
 * of those that were added, where it is found by halves. */
static uint8_t byte_of(uint32_t light, uint32_t samples, uint32_t least, uint32_t most) {
    while (least < most) {
        const uint32_t byte = (least + most) / 2;
        if (2 * light >= samples * (plt_linear[byte] + plt_linear[byte + 1])) {
            least = byte + 1;
        } else {
            most = byte;
        }
    }
    return (uint8_t)least;
}

void plt_mix_get(const plt_mix *m, uint32_t samples, uint8_t rgb[3]) {
    for (int c = 0; c < 3; c++) {
        rgb[c] = byte_of(m->light[c], samples, m->least[c], m->most[c]);
    }
}

#endif
