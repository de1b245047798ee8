/* light - the mean of colours, in linear light
 *
 * A byte of sRGB stands for so much light; the mean of several is the byte whose light is nearest
 * to the mean of theirs, the greater of two that are. All of it is in whole numbers: the table is
 * exact to half of a 65,535th, and that is all that is rounded. Equal colours have themselves for a
 * mean.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_LIGHT_H
#define PLT_SHADE_LIGHT_H

#include "engine/base/linear.h"

/* Up to 16 colours. */
typedef struct plt_mix {
    uint32_t light[3], total[3]; /* of bytes of red, green and blue: their light, and they */
    uint8_t least[3], most[3];   /* of them, where asked */
    uint8_t compares;
} plt_mix;

/* `compares`: plt_mix_differs will be asked. */
static inline void plt_mix_begin(plt_mix *m, int compares) {
    for (int c = 0; c < 3; c++) {
        m->light[c] = m->total[c] = 0;
        m->least[c] = 255;
        m->most[c] = 0;
    }
    m->compares = (uint8_t)compares;
}

/* A colour that so many samples have. */
static inline void plt_mix_add(plt_mix *m, const uint8_t rgb[3], uint32_t samples) {
    for (int c = 0; c < 3; c++) {
        m->light[c] += samples * plt_linear[rgb[c]];
        m->total[c] += samples * rgb[c];
    }
    for (int c = 0; m->compares && c < 3; c++) {
        m->least[c] = rgb[c] < m->least[c] ? rgb[c] : m->least[c];
        m->most[c] = rgb[c] > m->most[c] ? rgb[c] : m->most[c];
    }
}

/* Whether two of the colours are not alike (PLT_SAMPLES_ALIKE). */
static inline int plt_mix_differs(const plt_mix *m) {
    int differs = 0;
    for (int c = 0; c < 3; c++) {
        differs |= m->most[c] - m->least[c] > PLT_SAMPLES_ALIKE;
    }
    return differs;
}

/* The mean of the `samples` colours that were added, 1 to 16. */
void plt_mix_get(const plt_mix *m, uint32_t samples, uint8_t rgb[3]);

#endif
