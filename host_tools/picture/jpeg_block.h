/* jpeg_block - blocks of 8x8 samples as coefficients
 *
 * SPDX-License-Identifier: MIT */
#ifndef JPEG_BLOCK_H
#define JPEG_BLOCK_H
#include <stdint.h>

enum { JPEG_SIDE = 8, JPEG_BLOCK = 64 };

/* Number in a block, row by row, of each coefficient in the order of a file (T.81, figure 5). */
extern const uint8_t jpeg_zigzag[JPEG_BLOCK];

/* Steps of quantisation in a block's order, 1 .. 255, of luminance or of chrominance (T.81, tables
 * K.1 and K.2), scaled as the Independent JPEG Group does for a quality of 1 .. 100. */
void jpeg_steps(unsigned quality, int chrominance, uint8_t steps[JPEG_BLOCK]);

/* Samples, -128 .. 127, become coefficients (T.81, A.3.3), each divided by its step and rounded to
 * the nearest integer, within what a baseline file can hold. */
void jpeg_transform(int16_t block[JPEG_BLOCK], const uint8_t steps[JPEG_BLOCK]);

#endif
