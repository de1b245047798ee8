/* report_size - how long a device's output reports are
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_REPORT_SIZE_H
#define HID_REPORT_SIZE_H

#include <stddef.h>
#include <stdint.h>

/* Bytes of the longest output report that a report descriptor declares,
 * without its number; 0 when there is none. Any bytes may come. */
unsigned report_size_of(const uint8_t *descriptor, size_t bytes);

/* The same of a device at a path as hidapi gives it, from what Linux tells of
 * it, before it is opened; 0: not known. */
unsigned report_size_at(const char *path);

#endif
