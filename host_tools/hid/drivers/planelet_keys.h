/* planelet_keys - which devices are Planelet displays, and their keys
 *
 * For both drivers of the wire: driver_planelet, and the page's, which must not wait.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_PLANELET_KEYS_H
#define HID_PLANELET_KEYS_H
#include <stddef.h>

#include "host_tools/hid/device/display.h"
#include "platform/wire/wire.h"

/* In the order of enum wire_key, and without symbols: what a key looks like is the device's. */
static const display_key planelet_keys[] = {
    {"left", STEER_LEFT, 0, 0},   {"right", STEER_RIGHT, 0, 0},   {"up", STEER_UP, 0, 0},
    {"down", STEER_DOWN, 0, 0},   {"nearer", STEER_NEARER, 0, 0}, {"farther", STEER_FARTHER, 0, 0},
    {"reset", STEER_RESET, 0, 0}, {"still", STEER_STILL, 0, 0},   {NULL, STEER_LEFT, 0, 0}};
_Static_assert((int)STEER_STILL == (int)WIRE_KEY_STILL, "keys of the wire and of a scene");

/* pid.codes reserves 1209:0001 for tests; a product needs an id of its own. */
static const driver_id planelet_ids[] = {{0x1209, 0x0001, 0}, {0, 0, 0}};

#endif
