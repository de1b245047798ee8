/* wire_picture - tiles that are computed, and what their coding must be anywhere
 *
 * Marbles-like discs with noise on a ramp. Included by a test of this machine
 * and by one that runs on a Cortex-M4.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_WIRE_PICTURE_H
#define REFERENCE_WIRE_PICTURE_H

#include "engine/planelet_crc32.h"
#include "platform/wire/wire_tile.h"

enum { PICTURE_TILES = 64, PICTURE_NEAR = 3 };

/* CRC-32 of the coded bytes of all tiles, each exact, then near. */
#define PICTURE_CODED_CRC 0x9614EC38u

static inline void wire_picture_tile(unsigned tile, uint8_t pixels[512]) {
    uint8_t rgb[3 * WIRE_TILE_SIDE];
    uint32_t noise = tile * 2654435761u;
    for (unsigned i = 0; i < 256; i++) {
        const int x = (int)(i % 16) - 8, y = (int)(i / 16) - 8;
        noise = noise * 1664525u + 1013904223u;
        const unsigned grey = tile % 4 == 0        ? 40 + i / 16
                              : x * x + y * y < 50 ? 230 - (noise >> 29) * (tile % 4)
                                                   : 60;
        rgb[3 * (i % 16)] = (uint8_t)grey;
        rgb[3 * (i % 16) + 1] = (uint8_t)(grey * 15 / 16);
        rgb[3 * (i % 16) + 2] = (uint8_t)(grey * 14 / 16);
        if (i % 16 == 15) {
            wire_row_from_rgb(pixels + 32 * (i / 16), WIRE_RGB565, rgb, 16, 0, i / 16);
        }
    }
}

#endif
