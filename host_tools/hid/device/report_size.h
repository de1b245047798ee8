/* report_size - how long a device's reports are
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_REPORT_SIZE_H
#define HID_REPORT_SIZE_H

#include <stddef.h>
#include <stdint.h>

/* Bytes without a report's number; 0: there is none, or it is not known. */
typedef struct report_sizes {
    unsigned out, in;
} report_sizes;

/* The longest reports that a report descriptor declares. Any bytes may come. */
report_sizes report_sizes_of(const uint8_t *descriptor, size_t bytes);

/* The same of a device at a path as hidapi gives it, from /sys of Linux,
 * before it is opened. */
report_sizes report_sizes_at(const char *path);

#endif
