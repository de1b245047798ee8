/* wire_format - how a panel keeps its pixels
 *
 * A row of a tile or panel in a format is wire_row_bytes() bytes. Where
 * several pixels share a byte, the left one has the higher bits, and unused
 * low bits of the last byte are zero.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_FORMAT_H
#define PLT_WIRE_FORMAT_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum wire_format {
    WIRE_RGB565 = 0, /* 2 bytes: RRRRRGGG GGGBBBBB, as display controllers take them */
    WIRE_RGB888 = 1, /* 3 bytes: red, green, blue */
    WIRE_GREY8 = 2,  /* luma of BT.601 */
    WIRE_GREY4 = 3,  /* 2 pixels per byte, 15 is white */
    WIRE_MONO1 = 4,  /* 8 pixels per byte, 1 is lit; 8 x 8 ordered dither */
    WIRE_FORMATS = 5
};

enum { WIRE_TILE_SIDE = 16, WIRE_ROW_BYTES_MAX = 48, WIRE_TILE_BYTES_MAX = 768 };

/* A tile; at the right and lower edge of a panel it is smaller. */
typedef struct wire_tile_shape {
    uint8_t format, width, height; /* 1 .. WIRE_TILE_SIDE pixels */
} wire_tile_shape;

/* Bytes of a row of `width` pixels, 0 for an unknown format. */
uint32_t wire_row_bytes(unsigned format, uint32_t width);

/* `width` pixels of a row, 3 bytes each, into `to` in the format. (x, y): the
 * position of the first on the panel, for the dither; x a multiple of 8. */
void wire_row_from_rgb(uint8_t *to, unsigned format, const uint8_t *rgb, unsigned width, unsigned x,
                       unsigned y);

/* The inverse, for showing a panel on a computer: grey and mono become grey,
 * 565 is widened by repeating the high bits. */
void wire_row_to_rgb(uint8_t *rgb, unsigned format, const uint8_t *from, unsigned width);

#ifdef __cplusplus
}
#endif
#endif
