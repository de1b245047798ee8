/* fake_hidapi - a bus with devices on it, in place of hidapi when tests link
 *
 * Tests plug models in and out and turn on what the real library was found to
 * do (0.13.1 on Linux): reads that come back empty, input in pieces of a
 * packet, reports that never arrive, writes that take less, devices that go
 * in the middle of a frame, opens that are refused without a reason.
 *
 * SPDX-License-Identifier: MIT */
#ifndef FAKE_HIDAPI_H
#define FAKE_HIDAPI_H

#include <stddef.h>
#include <stdint.h>
#include <wchar.h>

/* The device's side; `context` is handed to all. Reports come whole, the
 * number of numbered ones first; unnumbered ones have none. */
typedef struct fake_device {
    const char *path;
    const char *place;    /* NULL: what a path of libusb says, else it is not known */
    unsigned collections; /* each has an entry; 0: as 1 */
    unsigned short vendor, product, usage_page;
    int interface;
    const wchar_t *serial, *maker, *name; /* NULL: not known */
    int numbered;
    void *context;
    void (*output)(void *context, const uint8_t *report, size_t bytes);
    void (*feature)(void *context, const uint8_t *report, size_t bytes);
    size_t (*input)(void *context, uint8_t *report, size_t room); /* 0: none now */
    void (*plugged)(void *context, int in);                       /* may be NULL */
} fake_device;

enum { FAKE_DEVICES = 80 };

extern struct fake_bus {
    const fake_device *device[FAKE_DEVICES]; /* NULL: an empty socket */

    int libusb;               /* no usage page; what is plugged in later is not seen before
                               * hid_exit and hid_init; error texts are not implemented */
    unsigned empty_reads;     /* of every n reads one returns 0 at once; 0: none */
    unsigned piece_bytes;     /* input reports come in pieces of so many bytes; 0: whole */
    unsigned drop_outputs;    /* of every n output reports one is taken and never arrives */
    unsigned short_writes;    /* of every n output reports one is taken in part */
    unsigned refuse_features; /* the next n feature reports fail */
    unsigned refuse_outputs;  /* the next n output reports fail */
    unsigned refuse_reports;  /* the next n reports of either kind fail */
    unsigned stall_ms;        /* the next report takes so long, and then fails; 0: no */
    unsigned late_ms;         /* feature reports are carried out, but so much later reported as
                               * failed; 0: never */
    unsigned slow_us;         /* every report takes so long */
    int denied;               /* enumeration shows devices, no open works */
    /* Before each output or feature report, of whatever device; and whenever time may have passed.
     * Both may be NULL. */
    void (*before)(void *context), (*passes)(void *context);
    void *context;         /* for them */
    uint64_t unplug_after; /* so many reports from now the first device goes; 0: never */
    uint64_t replug_ms;    /* ... and comes back so much later; 0: never */

    double last_fault; /* clock: when a refusal, or what was late or stalled, came to its end */
    uint64_t outputs, features, reads, opens, enumerations; /* counted */
    int alive, open;                                        /* hid_init called; devices open */
    unsigned wrong; /* uses that hidapi forbids: must stay 0 */
} fake_bus;

/* A bus without devices, switches off, counters zero. Nothing is open. */
void fake_bus_reset(void);
void fake_plug(unsigned socket, const fake_device *device);
void fake_unplug(unsigned socket);

#endif
