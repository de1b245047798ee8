/* deck_keys - see deck_keys.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/drivers/deck_keys.h"

#include <stddef.h>

#include "host_tools/hid/device/symbols.h"

/* A symbol lies in a key's lower left corner. */
#define AT(side, column, row) (column) * (side) + 4, ((row) + 1) * (side)-SYMBOL_SIDE - 4
#define KEYS_OF(side)                                                                              \
    {"top left", STEER_NEARER, AT(side, 0, 0)}, {"second of the top", STEER_UP, AT(side, 1, 0)},   \
        {"third of the top", STEER_FARTHER, AT(side, 2, 0)},                                       \
        {"fourth of the top", STEER_RESET, AT(side, 3, 0)},                                        \
        {"left of the second row", STEER_LEFT, AT(side, 0, 1)},                                    \
        {"second of the second row", STEER_DOWN, AT(side, 1, 1)},                                  \
        {"third of the second row", STEER_RIGHT, AT(side, 2, 1)}, {                                \
        "fourth of the second row", STEER_STILL, AT(side, 3, 1)                                    \
    }

const display_key deck_keys_72[] = {KEYS_OF(72), {NULL, STEER_LEFT, 0, 0}};
const display_key deck_keys_96[] = {KEYS_OF(96), {NULL, STEER_LEFT, 0, 0}};
const display_key deck_keys_120[] = {KEYS_OF(120),
                                     {"first dial to the left", STEER_LEFT, 0, 0},
                                     {"first dial to the right", STEER_RIGHT, 0, 0},
                                     {"second dial to the left", STEER_DOWN, 0, 0},
                                     {"second dial to the right", STEER_UP, 0, 0},
                                     {"third dial to the left", STEER_FARTHER, 0, 0},
                                     {"third dial to the right", STEER_NEARER, 0, 0},
                                     {"swipe to the left", STEER_RIGHT, 0, 0},
                                     {"swipe to the right", STEER_LEFT, 0, 0},
                                     {"strip, touched", STEER_STILL, 0, 0},
                                     {"strip, held", STEER_RESET, 0, 0},
                                     {NULL, STEER_LEFT, 0, 0}};
