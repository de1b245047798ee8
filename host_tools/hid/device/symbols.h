/* symbols - small signs in a picture, of what the keys below it do
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_SYMBOLS_H
#define HID_SYMBOLS_H

#include "host_tools/hid/device/keys.h"
#include "host_tools/picture/picture.h"

enum { SYMBOL_SIDE = 11 };

/* Draws the symbols of all keys that have a place, white with a dark edge, as far as they are in
 * the picture. `keys` may be NULL. */
void symbols_draw(picture *p, const display_key *keys);

#endif
