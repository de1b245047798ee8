/* texel - a texel of a tile, as sRGB bytes
 *
 * Blocks: S. Iourcha, K. Nayak and Z. Hong, US patent 5,956,431, 1997 (expired), had the idea of
 * two colours and a number per texel for a mixture of both; ours always has four, mixed in bytes.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TEXTURE_TEXEL_H
#define PLT_TEXTURE_TEXEL_H

#include <stdint.h>

enum { PLT_BLOCK_SIDE = 4, PLT_BLOCK_BYTES = 8 };

static inline uint32_t plt_texel_u16(const unsigned char *at) {
    return at[0] | (uint32_t)at[1] << 8;
}

/* 5, 6 and 5 bits, red the highest, to bytes: 31 and 63 are 255. */
static inline void plt_rgb565_bytes(uint32_t code, uint8_t rgb[3]) {
    const uint32_t r = code >> 11, g = code >> 5 & 63u, b = code & 31u;
    rgb[0] = (uint8_t)(r << 3 | r >> 2);
    rgb[1] = (uint8_t)(g << 2 | g >> 4);
    rgb[2] = (uint8_t)(b << 3 | b >> 2);
}

/* Colour 0 .. 3 of a block: its first, its second, and those a third of the way from one to the
 * other. */
static inline void plt_block_colour(const unsigned char *block, uint32_t number, uint8_t rgb[3]) {
    uint8_t end[2][3];
    plt_rgb565_bytes(plt_texel_u16(block), end[0]);
    plt_rgb565_bytes(plt_texel_u16(block + 2), end[1]);
    const uint32_t first = number == 0 ? 3 : number == 1 ? 0 : 4 - number;
    for (int c = 0; c < 3; c++) {
        rgb[c] = (uint8_t)((first * end[0][c] + (3 - first) * end[1][c] + 1) / 3);
    }
}

/* Of a tile of 8 x 8 texels, row by row. */
static inline void plt_texel_rgb565(const unsigned char *tile, uint32_t x, uint32_t y,
                                    uint8_t rgb[3]) {
    plt_rgb565_bytes(plt_texel_u16(tile + 2 * (8 * (y & 7u) + (x & 7u))), rgb);
}

/* Of a tile of 4 x 4 blocks: two colours, and 2 bits for each texel. */
static inline void plt_texel_block(const unsigned char *tile, uint32_t x, uint32_t y,
                                   uint8_t rgb[3]) {
    const unsigned char *block = tile + PLT_BLOCK_BYTES * (4 * (y >> 2 & 3u) + (x >> 2 & 3u));
    plt_block_colour(block, (uint32_t)block[4 + (y & 3u)] >> 2 * (x & 3u) & 3u, rgb);
}

#endif
