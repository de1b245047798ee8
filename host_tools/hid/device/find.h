/* find - which display is meant
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_FIND_H
#define HID_FIND_H

#include "host_tools/hid/device/display.h"

enum { FIND_ROOM = 64 };

typedef struct find_wish {
    const driver *const *drivers; /* to choose from, ended by NULL */
    const char *device;           /* "vid:pid" in hexadecimal, a path or a serial number;
                                   * NULL: the first display found */
    const driver *by;             /* NULL: the one that is for the device */
} find_wish;

/* Looks for the wish among what is plugged in. Returns the driver and fills
 * `info`, or NULL with a sentence in `f`. */
const driver *find_display(const find_wish *wish, port_info *info, fail *f);

/* The same device after it was gone: same ids, serial number and interface,
 * at any path. 1: it is there and `info` is as it is now. */
int find_again(port_info *info);

#endif
