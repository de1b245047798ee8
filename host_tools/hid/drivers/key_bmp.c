/* key_bmp - see key_bmp.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/drivers/key_bmp.h"

#include <string.h>

static void put_u32(uint8_t *to, uint32_t value) {
    for (unsigned i = 0; i < 4; i++) {
        to[i] = (uint8_t)(value >> 8 * i);
    }
}

void key_bmp_head(uint8_t to[KEY_BMP_HEAD], unsigned side, unsigned per_metre) {
    const unsigned pixels = 3 * side * side;
    memset(to, 0, KEY_BMP_HEAD);
    to[0] = 'B';
    to[1] = 'M';
    put_u32(to + 2, KEY_BMP_HEAD + pixels);
    put_u32(to + 10, KEY_BMP_HEAD);
    put_u32(to + 14, KEY_BMP_HEAD - 14);
    put_u32(to + 18, side);
    put_u32(to + 22, side);
    to[26] = 1;
    to[28] = 24;
    put_u32(to + 34, pixels);
    put_u32(to + 38, per_metre);
    put_u32(to + 42, per_metre);
}
