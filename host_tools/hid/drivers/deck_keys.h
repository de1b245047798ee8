/* deck_keys - what the keys and dials of Stream Decks with four columns or more do to a scene
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_DECK_KEYS_H
#define HID_DECK_KEYS_H

#include "host_tools/hid/device/keys.h"

/* In this order: key 0 to 3 of the first row, those below them, for each dial that turns a scene
 * two entries, to the left and to the right, and what is done on the strip. */
enum {
    DECK_KEYS_STEER = 8,
    DECK_DIALS_STEER = 3,
    DECK_SWIPE = DECK_KEYS_STEER + 2 * DECK_DIALS_STEER, /* to the left; then to the right */
    DECK_TOUCH = DECK_SWIPE + 2,
    DECK_HOLD
};

/* By the side of a key in pixels; those of 120 have dials. */
extern const display_key deck_keys_72[], deck_keys_96[], deck_keys_120[];

#endif
