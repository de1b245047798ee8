/* texture_code - texels as the image has them (SPEC.md, 4.22)
 *
 * SPDX-License-Identifier: MIT */
#ifndef TEXTURE_CODE_H
#define TEXTURE_CODE_H
#include <stdint.h>

#include "engine/texture/texel.h"

/* The nearest of 5, 6 and 5 bits. */
uint32_t texture_rgb565(const uint8_t rgb[3]);

/* The 8 bytes of a block for its 16 texels, row by row. */
void texture_block(const uint8_t texel[16][3], unsigned char block[PLT_BLOCK_BYTES]);

/* The sum of squares that a block's colours are off. */
uint32_t texture_block_error(const uint8_t texel[16][3],
                             const unsigned char block[PLT_BLOCK_BYTES]);

#endif
