/* find - which display is meant
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_FIND_H
#define HID_FIND_H

#include "host_tools/hid/device/display.h"

typedef struct find_wish {
    const driver *const *drivers; /* to choose from, ended by NULL */
    const char *device;           /* "vid:pid" in hexadecimal, a path or a serial number;
                                   * NULL: the first display found */
    const driver *by;             /* NULL: the one that is for the device */
} find_wish;

/* Looks for the wish among what is plugged in. Returns the driver and fills
 * `info`, or NULL with a sentence in `f`. */
const driver *find_display(const find_wish *wish, port_info *info, fail *f);

/* The same device after it was gone, and never one that may be another: same ids, serial number
 * and interface, and
 * - where its place is known: at the same place, at any path;
 * - else, if the wish names its path, or an equal device was there beside it: at the same path;
 * - else: the only one that there is.
 * 1: it is there and `info` is as it is now. */
int find_again(const find_wish *wish, port_info *info);

#endif
