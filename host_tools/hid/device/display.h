/* display - an open USB display, and what its driver does
 *
 * A driver is a file that knows one protocol; drivers/drivers.c lists them
 * all. A driver neither looks for devices nor opens them again: it reports
 * that its device is gone, and is closed.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_DISPLAY_H
#define HID_DISPLAY_H

#include <signal.h>

#include "host_tools/base/fail.h"
#include "host_tools/hid/device/keys.h"
#include "host_tools/hid/device/port.h"
#include "host_tools/hid/device/report_size.h"
#include "host_tools/picture/picture.h"

/* Printed wherever drivers are listed. */
#define DISPLAY_DISCLAIMER                                                                         \
    "implemented from published protocol notes; tested byte for byte against our own emulator "    \
    "only, not on hardware"

enum display_status {
    DISPLAY_OK = 0,
    DISPLAY_FAILED = -1, /* `f` says why; trying again does not help */
    DISPLAY_GONE = -2,   /* unplugged or silent: close, wait, open again */
    DISPLAY_STOPPED = -3 /* `stop` was set, and the picture did not come through soon */
};

enum { DISPLAY_NEAR_AUTO = 255 };

typedef struct driver driver;

typedef struct display {
    const driver *by;
    port *port;
    unsigned width, height; /* of the panel; set by driver.open */
    unsigned pieces;        /* of driver.forget; likewise */
    report_sizes reports;
    const volatile sig_atomic_t *stop; /* may be NULL: set from outside, to wait no longer */
    double stopped;                    /* clock: when a driver first saw it set; 0: not yet */
    keys_state keys;                   /* as the driver has heard; for a list of its own */
    void *state;                       /* the driver's, allocated in open, freed in close */
} display;

/* A device that a driver is for. */
typedef struct driver_id {
    uint16_t vendor, id;
    int interface; /* of several; a device whose interface is not known matches any */
} driver_id;

enum { DRIVER_ANY_INTERFACE = -1 /* of a driver_id: it is not known which */ };

/* Keys that are a picture together, and what one that goes on behind the frame around them has
 * between two of them. Below the last row there may be more of the picture. */
typedef struct key_grid {
    unsigned columns, rows, side; /* pixels */
    unsigned gap_x, gap_y;
} key_grid;

struct driver {
    const char *name;        /* "nexus" */
    const char *about;       /* "Corsair iCUE Nexus, 640x48" */
    const driver_id *ids;    /* ended by vendor 0 */
    int from_notes;          /* DISPLAY_DISCLAIMER is true of it */
    const display_key *keys; /* ended by a name of NULL; NULL: it has none that are known */
    const key_grid *grid;    /* NULL: the panel has no gaps, or none that are known */

    /* `display` holds port, driver, reports and stop, the rest is zero. Fills it. What another
     * program may have left unfinished on the device is reset here. */
    int (*open)(display *d, fail *f);

    /* Shows a picture of the panel's size: returns when the last of it
     * was handed over and the next may come. `p` is not kept. */
    int (*show)(display *d, const picture *p, fail *f);

    /* Of a driver whose `show` leaves out what has not changed (keys): the next `show` sends piece
     * 0 .. d->pieces - 1 in any case. NULL: `show` sends everything. */
    void (*forget)(display *d, unsigned piece);
    int renews; /* sends parts again by itself, in `tick`: nobody has to for it */

    /* NULL where there is none: */
    int (*confirm)(display *d, fail *f); /* until the device has confirmed the picture */
    int (*tick)(display *d); /* keeps a link alive, reads keys; at least 10 times per second */
    int (*brightness)(display *d, unsigned percent, fail *f);
    /* How far off colours may be while they move: so many steps, or
     * DISPLAY_NEAR_AUTO: the fewest with which `fps` frames per second get through. */
    void (*near)(display *d, unsigned steps, unsigned fps);
    int (*release)(display *d, fail *f); /* the device's own picture again */
    void (*close)(display *d);           /* only after an open that went well */
};

/* The first of `drivers` (ended by NULL) that is for this device, or NULL. */
const driver *driver_for(const driver *const *drivers, const port_info *info);

/* Opens port and driver; on failure all is closed. `stop` may be NULL. */
int display_open(display *d, const driver *by, const port_info *info,
                 const volatile sig_atomic_t *stop, fail *f);
void display_close(display *d); /* after a failed open it does nothing */

/* Whether `stop` was set 0.15 s ago: time enough for the rest of most pictures. For loops that send
 * many reports. */
int display_is_stopped(display *d);

/* For driver.tick: what has come, a report at a time (its number first), but no more than 32 of
 * them: a device that never stops is not listened to for ever. */
int display_hear(display *d, void (*take)(display *d, const uint8_t *report, size_t bytes));

/* driver.tick, or, for a driver that has none, whether the device is still there. */
int display_tick(display *d);

/* The display_status for a port_status. A report that was cut leaves the device in
 * the middle of a frame; like an unplug it is DISPLAY_GONE, and the display is closed
 * and opened again. */
int display_status(int port_status);

#endif
