/* palette - few colours that stand for many
 *
 * SPDX-License-Identifier: MIT */
#ifndef PALETTE_H
#define PALETTE_H
#include <stddef.h>
#include <stdint.h>

enum { PALETTE_FEW = 255, PALETTE_MANY = 2047 };

typedef struct palette {
    uint8_t (*colour)[3]; /* owned */
    uint32_t count;       /* at least 1 */
    uint32_t distinct;    /* colours that were asked for */
    uint32_t furthest;    /* of 255, from a colour to what stands for it, on any of the three */
    double mean;          /* of 255, the same, on average over all of them and all three */
    uint32_t *from;       /* the distinct ones, rising; owned */
    uint16_t *to;         /* ... and what stands for each; owned */
} palette;

/* Of colours of 24 bits, as often as they are there: themselves, if they are at most PALETTE_FEW,
 * or the means of as many boxes (P. Heckbert, Color Image Quantization for Frame Buffer Display,
 * 1982). If one of those is further than `near` off: of up to PALETTE_MANY boxes, as many as it
 * takes, and then of what is nearest to each (S. P. Lloyd, Least Squares Quantization in PCM,
 * 1982). The same for the same colours, on every machine. -1: memory is out. */
int palette_make(palette *p, const uint32_t *colour, size_t count, uint32_t near);
/* What stands for one of them. */
uint32_t palette_index(const palette *p, uint32_t colour);
void palette_free(palette *p);

#endif
