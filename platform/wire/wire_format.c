/* wire_format - see wire_format.h
 *
 * Luma: 77 R + 150 G + 29 B in units of 1/256 (BT.601; the weights add up to
 * 256, so that grey stays grey). Dither: B. Bayer, "An optimum method for
 * two-level rendition of continuous-tone pictures", 1973.
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "platform/wire/wire_format.h"

static const uint8_t bits_of[WIRE_FORMATS] = {16, 24, 8, 4, 1};

/* Thresholds 0 .. 63, each once; a pixel is lit above 4 * threshold + 1. */
static const uint8_t bayer[8][8] = {
    {0, 32, 8, 40, 2, 34, 10, 42},  {48, 16, 56, 24, 50, 18, 58, 26},
    {12, 44, 4, 36, 14, 46, 6, 38}, {60, 28, 52, 20, 62, 30, 54, 22},
    {3, 35, 11, 43, 1, 33, 9, 41},  {51, 19, 59, 27, 49, 17, 57, 25},
    {15, 47, 7, 39, 13, 45, 5, 37}, {63, 31, 55, 23, 61, 29, 53, 21},
};

uint32_t wire_row_bytes(unsigned format, uint32_t width) {
    return format < WIRE_FORMATS ? (width * bits_of[format] + 7) / 8 : 0;
}

static unsigned luma(const uint8_t *rgb) {
    return (77u * rgb[0] + 150u * rgb[1] + 29u * rgb[2]) >> 8;
}

static void to_565(uint8_t *to, const uint8_t *rgb) {
    const unsigned word = (rgb[0] & 0xF8u) << 8 | (rgb[1] & 0xFCu) << 3 | rgb[2] >> 3;
    to[0] = (uint8_t)(word >> 8);
    to[1] = (uint8_t)word;
}

/* Nearest of 16 steps of 17. */
static void to_grey4(uint8_t *to, const uint8_t *rgb, unsigned x) {
    const unsigned step = (luma(rgb) * 241u + 2048u) >> 12;
    *to = (uint8_t)(x & 1 ? *to | step : step << 4);
}

static void to_mono(uint8_t *to, const uint8_t *rgb, unsigned x, unsigned y) {
    const unsigned lit = luma(rgb) > 4u * bayer[y & 7][x & 7] + 1;
    *to = (uint8_t)((x & 7 ? *to : 0) | lit << (7 - (x & 7)));
}

void wire_row_from_rgb(uint8_t *to, unsigned format, const uint8_t *rgb, unsigned width, unsigned x,
                       unsigned y) {
    if (format == WIRE_RGB888) {
        memcpy(to, rgb, 3 * (size_t)width);
        return;
    }
    for (unsigned i = 0; format == WIRE_RGB565 && i < width; i++) {
        to_565(to + 2 * i, rgb + 3 * i);
    }
    for (unsigned i = 0; format == WIRE_GREY8 && i < width; i++) {
        to[i] = (uint8_t)luma(rgb + 3 * i);
    }
    for (unsigned i = 0; format == WIRE_GREY4 && i < width; i++) {
        to_grey4(to + i / 2, rgb + 3 * i, x + i);
    }
    for (unsigned i = 0; format == WIRE_MONO1 && i < width; i++) {
        to_mono(to + i / 8, rgb + 3 * i, x + i, y);
    }
}

static void grey_to_rgb(uint8_t *rgb, unsigned grey) {
    rgb[0] = rgb[1] = rgb[2] = (uint8_t)grey;
}

static void from_565(uint8_t *rgb, const uint8_t *from) {
    const unsigned word = (unsigned)from[0] << 8 | from[1];
    const unsigned r = word >> 11, g = word >> 5 & 63, b = word & 31;
    rgb[0] = (uint8_t)(r << 3 | r >> 2);
    rgb[1] = (uint8_t)(g << 2 | g >> 4);
    rgb[2] = (uint8_t)(b << 3 | b >> 2);
}

void wire_row_to_rgb(uint8_t *rgb, unsigned format, const uint8_t *from, unsigned width) {
    for (unsigned i = 0; i < width; i++, rgb += 3) {
        switch (format) {
        case WIRE_RGB565:
            from_565(rgb, from + 2 * i);
            break;
        case WIRE_RGB888:
            memcpy(rgb, from + 3 * i, 3);
            break;
        case WIRE_GREY8:
            grey_to_rgb(rgb, from[i]);
            break;
        case WIRE_GREY4:
            grey_to_rgb(rgb, 17u * (from[i / 2] >> (i & 1 ? 0 : 4) & 15));
            break;
        default:
            grey_to_rgb(rgb, from[i / 8] >> (7 - (i & 7)) & 1 ? 255 : 0);
        }
    }
}
