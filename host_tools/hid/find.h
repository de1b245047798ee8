/* find - which display is meant
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_FIND_H
#define HID_FIND_H

#include "host_tools/hid/display.h"

enum { FIND_ROOM = 64 };

/* What a user said: a device as "vid:pid" (hexadecimal), a path or a serial
 * number, NULL for the first display found; a driver, NULL for the device's
 * own. */
typedef struct find_wish {
    const char *device;
    const driver *by;
} find_wish;

/* Looks for the wish among what is plugged in. Returns the driver and fills
 * `info`, or NULL with a sentence in `f`. */
const driver *find_display(const find_wish *wish, port_info *info, fail *f);

/* The same device after it was gone: same ids, serial number and interface,
 * at any path. 1: it is there and `info` is as it is now. */
int find_again(port_info *info);

#endif
