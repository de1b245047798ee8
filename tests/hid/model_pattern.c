/* model_pattern - see pattern.h
 *
 * SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "tests/hid/pattern.h"

static uint32_t scramble(uint32_t v) {
    v = (v ^ v >> 16) * 0x7FEB352Du;
    v = (v ^ v >> 15) * 0x846CA68Bu;
    return v ^ v >> 16;
}

static uint32_t colour(unsigned n, unsigned x, unsigned y, unsigned w, unsigned h) {
    const unsigned side = h / 4 + 1, left = n * 7 % (w - w / 8), top = n * 5 % (h - h / 8);
    if (x - left < side && y - top < side) {
        return 0xFF0000u | (n & 7) << 5 << 8 | (x ^ y) % 2 * 0xC0;
    }
    if (x < w / 8 && y < h / 8) {
        return scramble(n << 24 ^ y << 12 ^ x);
    }
    if (y < h / 3) {
        return x * 255 / w << 16 | y * 255 / h << 8 | (n % 4 == 3 ? 0x80u : 0x40u);
    }
    if (x > w - w / 4) {
        return (x + y) % 3 == 0 ? 0xFFFFFFu : 0x000000u;
    }
    return x < w / 2 ? 0x2040A0u : 0x000000u;
}

void pattern_fill(unsigned n, unsigned w, unsigned h, uint8_t *rgb) {
    for (unsigned y = 0; y < h; y++) {
        for (unsigned x = 0; x < w; x++, rgb += 3) {
            const uint32_t c = colour(n, x, y, w, h);
            rgb[0] = (uint8_t)(c >> 16);
            rgb[1] = (uint8_t)(c >> 8);
            rgb[2] = (uint8_t)c;
        }
    }
}
