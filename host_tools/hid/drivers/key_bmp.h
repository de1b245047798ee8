/* key_bmp - the BMP file that a Stream Deck of the first generation has for a key
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_KEY_BMP_H
#define HID_KEY_BMP_H

#include <stdint.h>

enum { KEY_BMP_HEAD = 54 };

/* BITMAPFILEHEADER and BITMAPINFOHEADER of `side` x `side` pixels of 24 bits, the side a multiple
 * of 4; pixels per metre as the maker's own program writes them. */
void key_bmp_head(uint8_t to[KEY_BMP_HEAD], unsigned side, unsigned per_metre);

#endif
