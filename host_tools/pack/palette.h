/* palette - few colours that stand for many
 *
 * SPDX-License-Identifier: MIT */
#ifndef PALETTE_H
#define PALETTE_H
#include <stddef.h>
#include <stdint.h>

typedef struct palette {
    uint8_t colour[255][3];
    uint32_t count;    /* at least 1 */
    uint32_t distinct; /* colours that were asked for */
    uint32_t furthest; /* of 255, from a colour to what stands for it, on any of the three */
    uint32_t *from;    /* the distinct ones, rising; owned */
    uint8_t *to;       /* ... and what stands for each; owned */
} palette;

/* Of colours of 24 bits, as often as they are there: themselves, if they are at most `most`, or the
 * means of as many boxes (P. Heckbert, Color Image Quantization for Frame Buffer Display, 1982).
 * -1: memory is out. */
int palette_make(palette *p, const uint32_t *colour, size_t count, uint32_t most);
/* What stands for one of them. */
uint8_t palette_index(const palette *p, uint32_t colour);
void palette_free(palette *p);

#endif
