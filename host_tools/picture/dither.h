/* dither - pictures for panels of one bit, and of six bits per colour
 *
 * What a pixel becomes depends on its colour and its place alone. So a picture that stands still
 * is the same bits in every frame, and one that moves changes them only where it changes, which
 * diffused errors do not: a pixel would change all that follow it.
 *
 * SPDX-License-Identifier: MIT */
#ifndef DITHER_H
#define DITHER_H
#include <stdint.h>

enum { DITHER_SIDE = 32 };

/* Thresholds 0 .. 254, by place modulo 32: of a grey of L, L / 255 of all places light up. */
extern const uint8_t dither_threshold[DITHER_SIDE][DITHER_SIDE];

/* Whether the pixel of this colour at this place of a panel of one bit is lit. */
int dither_is_lit(const uint8_t *rgb, unsigned x, unsigned y);

/* A colour's 8 bits at this place of a panel that keeps the upper 6 of them: one of the two nearest
 * of 64 levels, its upper bits repeated in the lower two. Black and white stay as they are. */
uint8_t dither_six_bits(uint8_t value, unsigned x, unsigned y);

#endif
