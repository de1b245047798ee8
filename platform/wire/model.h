/* model - what the predictive coder expects of the next pixel
 *
 * Invariants: at (x, y) row[0 .. x-1] are pixels of this row and row[x ..] of
 * the row above, as the decoder has them; every sample is within its format.
 *
 * Sources: M. Weinberger, G. Seroussi, G. Sapiro, "LOCO-I" (JPEG-LS), 2000,
 * for the median prediction, the contexts from gradients and the bounded
 * error; the colours follow the neighbour of the nearest green.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_MODEL_H
#define PLT_WIRE_MODEL_H

#include "platform/wire/samples.h"

/* A sample's chances: is it as predicted (2), the sign (3), how many bits the
 * size has, one question each, and the upper of the bits below the first. */
enum { MODEL_ZERO = 0, MODEL_SIGN = 2, MODEL_LENGTH = 5, MODEL_LENGTHS = 5, MODEL_UPPER = 10 };
enum { MODEL_SAMPLE = 12, MODEL_CLASSES = 5, MODEL_BITS = 7 };

/* Index of the first chance of each kind. */
enum {
    MODEL_SAME = 0,                                           /* is it as on the panel? */
    MODEL_FIRST = MODEL_SAME + 24,                            /* the first sample */
    MODEL_EXACT = MODEL_FIRST + MODEL_CLASSES * MODEL_SAMPLE, /* are both others as expected? */
    MODEL_SECOND = MODEL_EXACT + 6,
    MODEL_THIRD = MODEL_SECOND + MODEL_SAMPLE,
    MODEL_CHANCES = MODEL_THIRD + MODEL_SAMPLE
};

/* Bits of the first byte of a predicted tile. */
enum { MODEL_NEAR = 15, MODEL_DELTA = 16, MODEL_FLAGS = 31 };

/* A pixel never needs more bytes: 32 decisions with a chance (delta, exact, and
 * 10 of each sample) at 7.001 bits, 6 even bits of each sample: 243 bits. */
enum { MODEL_PIXEL_BYTES = 32 };

typedef struct wire_model {
    uint16_t chance[MODEL_CHANCES];
    wire_sample row[WIRE_TILE_SIDE];
    wire_sample corner;           /* above and left of the next pixel */
    uint16_t here, above, above2; /* bits of rows: changed pixels, or mono's pixels */
    uint8_t format, width, x, y, flags;
    uint8_t step; /* 1: exact; a sample may be step / 2 off */
} wire_model;

void wire_model_start(wire_model *m, wire_tile_shape shape, unsigned flags);

static inline int wire_distance(int a, int b) {
    return a < b ? b - a : a - b;
}

#endif
