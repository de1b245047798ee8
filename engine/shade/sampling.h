/* sampling - several samples per pixel, and how they become its colour
 *
 * A frame of samples is traced as one whose rows and columns are `across` times as close
 * (plt_view_refine); a square of side^2 rays covers (side / across)^2 pixels. Where all samples of
 * a pixel hit one triangle, that is shaded once, along the ray through the pixel's middle, and
 * what is seen is what one sample shows; else each triangle is, and their mean is taken.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_SAMPLING_H
#define PLT_SHADE_SAMPLING_H

#include "engine/shade/camera.h"
#include "engine/shade/diagram.h"

/* What pixels are shaded by, where there may be several samples, or distances. */
typedef struct plt_sampling {
    const plt_frame *frame;
    plt_view middle; /* through the middles of pixels */
    plt_depths depths;
    uint64_t mixed; /* adaptive: bit 8 y + x: colours of pixel (x, y) of the square are not alike,
                     * and it has not been traced again */
    uint8_t across; /* samples along a pixel's side: 1, 2 or 4; of the current square */
    uint8_t adapts;
    uint8_t x,
        y; /* adaptive, across 4: the pixel of the square that what is traced again begins at */
    uint8_t columns, rows; /* ... and its pixels; 0: all of the square is traced */
} plt_sampling;

/* Samples along a pixel's side, to begin with; 0: there is no such number. */
static inline uint32_t plt_samples_across(unsigned samples) {
    switch (samples) {
    case 0:
    case PLT_SAMPLES_ONE:
        return 1;
    case PLT_SAMPLES_FOUR:
    case PLT_SAMPLES_ADAPTIVE:
        return 2;
    case PLT_SAMPLES_SIXTEEN:
        return 4;
    default:
        return 0;
    }
}

#endif
