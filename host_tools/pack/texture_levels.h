/* texture_levels - a picture and its mip levels, in linear light
 *
 * Integers alone, so that the levels are the same on every machine.
 *
 * SPDX-License-Identifier: MIT */
#ifndef TEXTURE_LEVELS_H
#define TEXTURE_LEVELS_H
#include "host_tools/picture/picture.h"

typedef struct texture_level {
    uint32_t width, height;
    uint16_t *light; /* red, green, blue of each texel, rows top down; owned */
} texture_level;

/* Each -1 when memory is out; the level is then empty. */
int texture_level_first(texture_level *l, const picture *p);
/* The next: half as wide and high, rounded down, at least 1. A texel is the mean of what lies under
 * it, parts of texels by their share. */
int texture_level_next(texture_level *l, const texture_level *before);
void texture_level_free(texture_level *l);

/* The nearest sRGB bytes of a texel; beyond the borders that of the nearest within. */
void texture_level_bytes(const texture_level *l, uint32_t x, uint32_t y, uint8_t rgb[3]);

#endif
