/* pages - see pages.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/drivers/pages.h"

#include "host_tools/picture/dither.h"

enum { ROWS = 8 };

void pages_columns(const picture *p, unsigned page, unsigned left, unsigned count, uint8_t *to) {
    for (unsigned i = 0; i < count; i++) {
        to[i] = 0;
        for (unsigned row = 0; row < ROWS && ROWS * page + row < p->height; row++) {
            const unsigned x = left + i, y = ROWS * page + row;
            const uint8_t *rgb = p->rgb + 3 * ((size_t)y * p->width + x);
            to[i] |= (uint8_t)((unsigned)dither_is_lit(rgb, x, y) << row);
        }
    }
}
