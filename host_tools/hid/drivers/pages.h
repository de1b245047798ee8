/* pages - panels of one bit in pages, as their controllers keep them
 *
 * A page is eight rows; a byte is one column of it, its lowest bit on top.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_PAGES_H
#define HID_PAGES_H

#include "host_tools/picture/picture.h"

/* `count` bytes of a page, from column `left` on, dithered (picture/dither.h). Rows below the
 * picture are dark. */
void pages_columns(const picture *p, unsigned page, unsigned left, unsigned count, uint8_t *to);

#endif
