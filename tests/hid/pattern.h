/* pattern - test pictures that both ends of a cable can make
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_PATTERN_H
#define HID_PATTERN_H

#include <stdint.h>

/* Picture `number` of any size, rows of 3 bytes per pixel: a plain ground, a
 * ramp, edges of one pixel, a corner of noise, and a square that moves. Every
 * coder is used, and most of two successive pictures is the same. */
void pattern_fill(unsigned number, unsigned width, unsigned height, uint8_t *rgb);

#endif
