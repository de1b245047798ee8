/* gaps - a picture that goes on behind the frame around a display's keys
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_GAPS_H
#define HID_GAPS_H

#include "host_tools/hid/device/display.h"

/* The size of such a picture for a panel of keys, and of rows below them: those are as wide as keys
 * and gaps together, and so larger than on the panel. */
void gaps_size(const key_grid *grid, unsigned width, unsigned height, unsigned *span_width,
               unsigned *span_height);

/* What of it the panel shows: pixels of keys as they are, of what is below them the nearest. `span`
 * has the size for `panel`. */
void gaps_cut(const key_grid *grid, const picture *span, picture *panel);

/* Moves the symbols of keys, at most KEYS_MOST, to where their keys are in such a picture; `to` has
 * room for KEYS_MOST + 1. */
void gaps_keys(const key_grid *grid, const display_key *keys, display_key *to);

#endif
