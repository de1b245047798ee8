/* ssd0323 - see ssd0323.h
 *
 * SPDX-License-Identifier: MIT */
#include "platform/ssd0323/ssd0323.h"

enum {
    SET_COLUMNS = 0x15, /* first, last; a column is two pixels */
    SET_ROWS = 0x75,    /* first, last */
    SET_CONTRAST = 0x81,
    FULL_CURRENT = 0x86,
    SET_REMAP = 0xA0,
    SET_START_LINE = 0xA1,
    SET_OFFSET = 0xA2,
    SHOW_MEMORY = 0xA4,
    SET_ROWS_DRIVEN = 0xA8, /* less one */
    DISPLAY_OFF = 0xAE,
    DISPLAY_ON = 0xAF
};

/* Rows alternate between both sides of the glass, and go on in the direction of columns; the
 * left pixel is the upper half of a byte. */
enum { REMAP_SPLIT_AND_NIBBLES = 0x52 };

enum { LEVELS = 16, LUMA_MOST = 255, THRESHOLDS = 64 };

static void command(uint8_t byte) {
    board_panel_put(0, byte);
}

static void command_of(uint8_t byte, uint8_t value) {
    command(byte);
    command(value);
}

/* Pixels that follow go there, row by row. */
static void set_window(unsigned x, unsigned y, unsigned width, unsigned height) {
    command(SET_COLUMNS);
    command((uint8_t)(x / 2));
    command((uint8_t)((x + width - 1) / 2));
    command(SET_ROWS);
    command((uint8_t)y);
    command((uint8_t)(y + height - 1));
}

void ssd0323_open(void) {
    command(DISPLAY_OFF);
    command_of(SET_ROWS_DRIVEN, SSD0323_HEIGHT - 1);
    command_of(SET_START_LINE, 0);
    command_of(SET_OFFSET, 0x4C);
    command_of(SET_REMAP, REMAP_SPLIT_AND_NIBBLES);
    command_of(SET_CONTRAST, 0x40);
    command(FULL_CURRENT);
    command(SHOW_MEMORY);
    ssd0323_clear();
    command(DISPLAY_ON);
}

void ssd0323_clear(void) {
    set_window(0, 0, SSD0323_WIDTH, SSD0323_HEIGHT);
    for (unsigned i = 0; i < SSD0323_WIDTH / 2 * SSD0323_HEIGHT; i++) {
        board_panel_put(1, 0);
    }
}

unsigned ssd0323_luma(const uint8_t rgb[3]) {
    return (77u * rgb[0] + 150u * rgb[1] + 29u * rgb[2] + 128u) >> 8;
}

/* Bayer's matrix: the bits of x ^ y and of y, the lowest of both first. */
static unsigned threshold(unsigned x, unsigned y) {
    unsigned order = 0;
    for (unsigned bit = 0; bit < 3; bit++) {
        order = order << 2 | ((x ^ y) >> bit & 1u) << 1 | (y >> bit & 1u);
    }
    return 2 * order + 1; /* of 128: none is 0, and none 1 */
}

/* Below LEVELS, as a threshold is below 2 * THRESHOLDS. */
unsigned ssd0323_grey(unsigned luma, unsigned x, unsigned y) {
    return (luma * (LEVELS - 1) * 2 * THRESHOLDS + threshold(x, y) * LUMA_MOST) /
           (LUMA_MOST * 2 * THRESHOLDS);
}

void ssd0323_tile(const plt_tile *tile, unsigned left, unsigned top) {
    set_window(left + tile->x, top + tile->y, tile->width, tile->height);
    for (unsigned row = 0; row < tile->height; row++) {
        const uint8_t *rgb = tile->rgb + 3u * row * tile->width;
        for (unsigned i = 0; i < tile->width; i += 2, rgb += 6) {
            const unsigned x = tile->x + i, y = tile->y + row;
            unsigned pair = ssd0323_grey(ssd0323_luma(rgb), x, y) << 4;
            if (i + 1 < tile->width) {
                pair |= ssd0323_grey(ssd0323_luma(rgb + 3), x + 1, y);
            }
            board_panel_put(1, (uint8_t)pair);
        }
    }
}
