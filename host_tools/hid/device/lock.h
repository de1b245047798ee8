/* lock - one program per display
 *
 * On hidraw any number of programs may write to a device, and their reports then interleave; with
 * libusb the second cannot open it. So the node is locked (flock): the system lets go of it when
 * the program ends, however it ends, and no lock is ever stale.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_LOCK_H
#define HID_LOCK_H

enum lock_status {
    LOCK_NONE = -1, /* the path is no file of ours to lock: libusb's, or it may not be opened */
    LOCK_HELD = -2  /* by another program */
};

/* A descriptor for lock_release, or a lock_status. `path` is as hidapi gives it. If it is held,
 * `holder` is the number of the process, 0: not known. */
int lock_take(const char *path, long *holder);
void lock_release(int lock); /* a lock_status is allowed */

#endif
