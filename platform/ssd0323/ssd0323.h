/* ssd0323 - a display of 128x64 pixels in 16 greys, two pixels in a byte
 *
 * How bytes get to the controller is the board's: board_panel_put. Where a tile lies, its x is
 * even, so that no byte is of two tiles.
 *
 * Greys are the luma of a pixel, spread over the 16 levels by an ordered dither of 8x8: it depends
 * on the pixel alone and on where it is, so that what does not move does not flicker.
 *
 * Source: Solomon Systech, SSD0323 (commands 15h, 75h, 81h, 86h, A0h to A4h, A8h, AEh, AFh);
 * B. E. Bayer, An optimum method for two-level rendition of continuous-tone pictures, 1973 (the
 * order of thresholds); ITU-R BT.601 (luma).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SSD0323_H
#define PLT_SSD0323_H

#include <stdint.h>

#include "engine/planelet.h"

enum { SSD0323_WIDTH = 128, SSD0323_HEIGHT = 64 };

/* Given by the board: sends a byte, of pixels (1) or of a command (0), most significant bit
 * first, and returns when the controller has it. */
void board_panel_put(int is_pixels, uint8_t byte);

/* Sets the controller up, which was just reset, and makes every pixel black. */
void ssd0323_open(void);
/* Makes every pixel black. */
void ssd0323_clear(void);

/* A tile whose frame begins at pixel (left, top) of the display; all of it lies on the display,
 * and left + tile->x is even. The last pixel of a row of odd width has a black one beside it. */
void ssd0323_tile(const plt_tile *tile, unsigned left, unsigned top);

/* The grey of a pixel at (x, y) of the frame, 0 .. 15, and of what has `luma` 0 .. 255 there. */
unsigned ssd0323_luma(const uint8_t rgb[3]);
unsigned ssd0323_grey(unsigned luma, unsigned x, unsigned y);

#endif
