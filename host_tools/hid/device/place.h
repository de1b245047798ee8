/* place - the USB port that a device is plugged into, as far as the system says
 *
 * Two displays of one kind without a serial number differ in nothing else that stays: a path is a
 * number of the order in which they came.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_PLACE_H
#define HID_PLACE_H

enum { PLACE_BYTES = 64 };

/* "1-2.4": bus 1, its port 2, port 4 of the hub there; "" when it is not known: not USB, not Linux,
 * or a libusb path of hidapi before 0.11. `path` is as hidapi gives it. */
void place_of(const char *path, char place[PLACE_BYTES]);

/* The same with another folder for /sys. */
void place_in(const char *sys, const char *path, char place[PLACE_BYTES]);

#endif
