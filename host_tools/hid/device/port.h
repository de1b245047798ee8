/* port - whole reports to and from a USB display: all that is used of hidapi
 *
 * The only file that names hidapi is port.c. It hides the quirks: reads that
 * return empty before their time, and writes of less than a report.
 *
 * A report's first byte is its number, 0 for a device whose reports have none.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_PORT_H
#define HID_PORT_H

#include <stddef.h>
#include <stdint.h>

#include "host_tools/base/fail.h"
#include "host_tools/hid/device/place.h"

/* A device as the system lists it; texts are UTF-8 and "" when not known. */
typedef struct port_info {
    char path[256], serial[128], maker[128], product[128];
    uint16_t vendor, id;
    uint16_t usage_page; /* 0: not known (hidapi on libusb) */
    int interface;       /* -1: not known */
    char place[PLACE_BYTES];
    unsigned equals; /* others in the list that differ from it in path and place at most */
} port_info;

typedef struct port port;

enum port_status {
    PORT_OK = 0,
    PORT_GONE = -1, /* the device is gone: close, then look again */
    PORT_CUT = -2   /* the system accepted only a part: the report did not go */
};

/* Lists what is plugged in now, each path once: hidapi has an entry for each collection of a
 * device. Returns how many; `*list` is the caller's to free, NULL if there are none.
 * hidapi is started again for it (otherwise it never sees a new device on libusb);
 * no port may be open. */
unsigned port_list(port_info **list);

/* Whether ids, interface and serial number are the same. */
int port_is_equal(const port_info *a, const port_info *b);

/* Opens a device of the list, for this program alone (lock.h). On failure `f` says why and what to
 * do. */
port *port_open(const port_info *info, fail *f);
void port_close(port *p); /* NULL is allowed */

/* Hands over one output report, or one feature report. PORT_OK means
 * that the system has it; only an answer shows that the device has it. A feature report that is
 * not acknowledged in time, by a device that is still there, counts as delivered. */
int port_output(port *p, const uint8_t *report, size_t bytes);
int port_feature(port *p, const uint8_t *report, size_t bytes);

/* One input report (its number first, if reports have numbers): its size, 0
 * when none came within `wait_ms`, or PORT_GONE. Empty reports are skipped. */
int port_input(port *p, uint8_t *report, size_t room, unsigned wait_ms);

/* Counted since port_open. */
typedef struct port_statistics {
    uint64_t reports, bytes, cut;
} port_statistics;
void port_statistics_get(const port *p, port_statistics *statistics);

#endif
