/* model - what the predictive coder expects of the next pixel, bit by bit
 *
 * Encoder and decoder run this same machine: it says which chance the next
 * bit has, is told the bit, and ends with a pixel. So they cannot disagree,
 * and a decoder can stop between any two bits.
 *
 * Invariants: at (x, y) row[0 .. x-1] are pixels of this row and row[x ..] of
 * the row above; every sample is within its format; a pixel takes at most
 * 3 * 260 bits, whatever they are.
 *
 * Sources: M. Weinberger, G. Seroussi, G. Sapiro, "LOCO-I" (JPEG-LS), 2000,
 * for the median prediction, the contexts from gradients and the bounded
 * error; the colours follow the neighbour of the nearest green.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_MODEL_H
#define PLT_WIRE_MODEL_H

#include "platform/wire/samples.h"

/* Places of the chances. */
enum {
    MODEL_SAME = 0,                 /* 16: is the pixel as on the panel? */
    MODEL_FIRST = MODEL_SAME + 16,  /* 6 classes of 8: zero, sign, lengths */
    MODEL_EXACT = MODEL_FIRST + 48, /* 6: are both other samples as expected? */
    MODEL_SECOND = MODEL_EXACT + 6, /* zero, sign, lengths of red */
    MODEL_THIRD = MODEL_SECOND + 5, /* of blue: zero, 3 signs, lengths */
    MODEL_CHANCES = MODEL_THIRD + 7
};

/* Bits of the first byte of a predicted tile. */
enum { MODEL_NEAR = 15, MODEL_DELTA = 16, MODEL_FLAGS = 31 };

/* A length of MODEL_UNARY and more goes on in Elias's gamma code of at most
 * MODEL_GAMMA_BITS: a steep edge then costs 15 bits to handle, not 60. */
enum { MODEL_UNARY = 8, MODEL_GAMMA_BITS = 7, MODEL_FAR = 3 };

/* What the next bit says. */
enum wire_model_stage {
    AT_SAME,
    AT_MONO,
    AT_ZERO,
    AT_SIGN,
    AT_LENGTH,
    AT_GAMMA,
    AT_REST,
    AT_SUFFIX,
    AT_EXACT
};

typedef struct wire_model {
    uint16_t chance[MODEL_CHANCES];
    wire_sample row[WIRE_TILE_SIDE];
    wire_sample corner;           /* above and left of the next pixel */
    wire_sample guess;            /* of the next pixel */
    wire_sample old;              /* what the panel shows there: set by the caller */
    uint16_t here, above, above2; /* bits of rows: changed pixels, or mono's pixels */
    uint8_t format, width, x, y, flags;
    uint8_t step; /* 1: exact; a sample may be step / 2 off */
    uint8_t stage, which, kind, shift, count, suffix, negative, second_sign;
} wire_model;

void wire_model_start(wire_model *m, wire_tile_shape shape, unsigned flags);

/* Once before the bits of every pixel, with `old` set when MODEL_DELTA is. */
void wire_model_pixel(wire_model *m);

/* The chance of the next bit; NULL: 1 and 0 are equally likely. */
uint16_t *wire_model_chance(wire_model *m);

/* Takes the next bit. 1: the pixel is complete and in row[x] of before, x and
 * y are moved on. -1: no encoder would do that. */
int wire_model_bit(wire_model *m, unsigned bit);

/* Encoder: the bit that leads towards `pixel`. */
unsigned wire_model_wish(const wire_model *m, wire_sample pixel);

static inline int wire_distance(int a, int b) {
    return a < b ? b - a : a - b;
}

/* What (value - guess) becomes in steps. */
static inline int wire_model_steps(int difference, int step) {
    const int half = step / 2;
    return difference >= 0 ? (difference + half) / step : -((half - difference) / step);
}

#endif
