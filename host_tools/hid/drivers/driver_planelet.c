/* driver_planelet - a display that speaks Planelet's own wire (platform/WIRE.md)
 *
 * What waits, and for how long; the rest is planelet_link.h's.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "host_tools/base/clock.h"
#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/hid/drivers/planelet_link.h"

enum {
    WAIT_MS = 2,
    OPEN_MS = 1500,  /* for the device to answer the first hello */
    STUCK_MS = 1500, /* without anything going out or in: the display is gone */
    SLOW_MS = 5000,  /* for a picture, in addition to the time of its bytes at SLOW_BYTES per ms */
    SLOW_BYTES = 4,  /* half of what the slowest USB link carries */
    IN_BYTES = 64,   /* at most: hidapi on libusb reads a packet of full speed */
    RENEW_MS = 20,   /* between two tiles that are sent again while nothing else is to be sent */
    TICK_MS = 100    /* that a tick may send for, however often the device asks again */
};

typedef struct planelet {
    planelet_link link;
    uint8_t *shown;   /* what the panel shows, for tiles that say only what differs */
    uint32_t begun;   /* ms: when the call that waits now began */
    uint32_t whole;   /* ms: the longest a picture may take; a lossy link may never finish it */
    uint32_t renewed; /* ms: when a tile was last sent again */
} planelet;

static void take_report(display *d, const uint8_t *report, size_t bytes) {
    planelet *p = d->state;
    planelet_link_take(&p->link, d, report, bytes);
}

/* Waits for a report, and reads what else came; PORT_OK or PORT_GONE. */
static int read_reports(display *d, unsigned wait_ms) {
    uint8_t report[IN_BYTES];
    const int bytes = port_input(d->port, report, sizeof report, wait_ms);
    if (bytes <= 0) {
        return bytes == 0 ? PORT_OK : PORT_GONE;
    }
    take_report(d, report, (size_t)bytes);
    return display_hear(d, take_report) == DISPLAY_OK ? PORT_OK : PORT_GONE;
}

/* One that the system accepted only in part is lost, and the wire sends its content again. */
static int send_report(display *d, int *sent) {
    planelet *p = d->state;
    return planelet_link_send(&p->link, d->port, sent) == PORT_GONE ? PORT_GONE : PORT_OK;
}

/* Sends one report, then reads all that came; waits only if none was sent. */
static int exchange(display *d, unsigned wait_ms, int *sent) {
    planelet *p = d->state;
    wire_poll(&p->link.peer, clock_ms());
    const int status = send_report(d, sent);
    return status == PORT_OK ? read_reports(d, *sent ? 0 : wait_ms) : status;
}

/* A device that was reset may answer as another; an exchange may see only that it is up
 * again. */
static int is_other_size(const display *d) {
    const planelet *p = d->state;
    const wire_caps *peer = wire_other(&p->link.peer);
    return d->width > 0 && wire_is_up(&p->link.peer) &&
           (peer->width != d->width || peer->height != d->height);
}

/* Exchanges reports until `is_so`, and not one more: with nothing new to show the wire
 * continues to refine what is there. GONE when nothing is heard for `patience_ms`,
 * FAILED when the call lasts longer than a whole picture may, STOPPED shortly after
 * `stop` was set. */
static int exchange_until(display *d, int (*is_so)(const planelet *p), unsigned patience_ms) {
    planelet *p = d->state;
    uint32_t heard = p->link.peer.stats.reports_in, since = clock_ms();
    while (!is_so(p) && !is_other_size(d)) {
        int sent;
        if (clock_ms() - p->begun > p->whole) {
            return DISPLAY_FAILED;
        }
        if (display_is_stopped(d)) {
            return DISPLAY_STOPPED;
        }
        if (exchange(d, WAIT_MS, &sent) != PORT_OK) {
            return DISPLAY_GONE;
        }
        if (p->link.peer.stats.reports_in != heard) {
            heard = p->link.peer.stats.reports_in;
            since = clock_ms();
        } else if (clock_ms() - since > patience_ms) {
            return DISPLAY_GONE;
        }
    }
    return DISPLAY_OK;
}

/* As exchange_until, for a picture; an error when it does not get through, or no longer
 * fits. */
static int deliver(display *d, int (*is_so)(const planelet *p), fail *f) {
    const int status = exchange_until(d, is_so, STUCK_MS);
    if (status == DISPLAY_OK && is_other_size(d)) {
        const wire_caps *peer = wire_other(&((planelet *)d->state)->link.peer);
        return fail_set(f, NULL, "the display changed its size to %u x %u; start again",
                        peer->width, peer->height);
    }
    return status != DISPLAY_FAILED
               ? status
               : fail_set(f, NULL,
                          "the display answers, but no picture gets through in %u seconds: too "
                          "many reports are lost; try another cable or port",
                          (unsigned)((const planelet *)d->state)->whole / 1000);
}

static int is_up(const planelet *p) {
    return wire_is_up(&p->link.peer);
}

static int is_idle(const planelet *p) {
    return !wire_is_up(&p->link.peer) || wire_frames_out_idle(&p->link.out);
}

static int is_done(const planelet *p) {
    return !wire_is_up(&p->link.peer) || wire_frames_out_done(&p->link.out);
}

static int open_end(planelet *p, report_sizes sizes, fail *f) {
    if (planelet_link_open(&p->link, &sizes, IN_BYTES) != 0) {
        return fail_set(f, NULL,
                        "reports of %u bytes out and %u in are not for the planelet driver (8 to "
                        "1024 and 8 to 64); choose another with --driver",
                        sizes.out, sizes.in);
    }
    p->begun = clock_ms();
    p->whole = UINT32_MAX; /* the greeting has a limit of its own */
    return DISPLAY_OK;
}

/* Sends hello until the device has answered what it is. */
static int greet(display *d, fail *f) {
    planelet *p = d->state;
    const int status = exchange_until(d, is_up, OPEN_MS);
    if (status != DISPLAY_OK) {
        fail_set(f, NULL,
                 "the device does not answer as a planelet display; is it one? Else "
                 "choose another with --device or --driver");
        return status;
    }
    const wire_caps *peer = wire_other(&p->link.peer);
    unsigned tiles;
    const enum planelet_panel panel = planelet_link_panel(&p->link, &tiles);
    if (panel == PLANELET_NO_PANEL) {
        return fail_set(f, NULL, "the device has no display; choose another with --device");
    }
    if (panel == PLANELET_PANEL_TOO_LARGE) {
        return fail_set(f, NULL,
                        "its %u x %u pixels are %u tiles, %u (WIRE_TILES_MAX) are the most; "
                        "choose another with --device",
                        peer->width, peer->height, tiles, (unsigned)WIRE_TILES_MAX);
    }
    d->width = peer->width, d->height = peer->height;
    const uint32_t bytes = wire_row_bytes(peer->format, d->width) * d->height;
    p->whole = SLOW_MS + bytes / SLOW_BYTES;
    p->shown = malloc(bytes); /* without it every tile is sent whole */
    if (p->shown != NULL) {
        wire_frames_reference(&p->link.out, p->shown, bytes);
    }
    return picture_make(&p->link.frame, d->width, d->height, f);
}

static void planelet_close(display *d) {
    planelet *p = d->state;
    picture_free(&p->link.frame);
    free(p->shown);
    free(p);
    d->state = NULL;
}

static int planelet_open(display *d, fail *f) {
    planelet *p = calloc(1, sizeof *p);
    d->state = p;
    if (p == NULL) {
        return fail_set(f, NULL, "out of memory; close other programs");
    }
    int status = open_end(p, d->reports, f);
    if (status == DISPLAY_OK) {
        status = greet(d, f);
    }
    if (status != DISPLAY_OK) {
        planelet_close(d);
    }
    return status;
}

static int say_error(planelet *p, fail *f) {
    uint32_t detail = 0;
    const unsigned code = wire_error_read(&p->link.peer, &detail);
    return fail_set(f, NULL, "the display reports error %u (%u); see platform/WIRE.md", code,
                    detail);
}

static int planelet_show(display *d, const picture *shown, fail *f) {
    planelet *p = d->state;
    p->begun = clock_ms();
    for (;;) {
        int status = deliver(d, is_idle, f);
        status = status == DISPLAY_OK ? deliver(d, is_up, f) : status; /* after a reset it is not */
        if (status != DISPLAY_OK) {
            return status;
        }
        if (planelet_link_show(&p->link, shown) == WIRE_OK) {
            return deliver(d, is_idle, f);
        }
        if (p->link.peer.other_error != WIRE_FINE) {
            return say_error(p, f);
        }
    }
}

/* A session that ends meanwhile starts again, with the whole picture. */
static int planelet_confirm(display *d, fail *f) {
    planelet *p = d->state;
    p->begun = clock_ms();
    for (;;) {
        int status = deliver(d, is_done, f);
        if (status != DISPLAY_OK || wire_frames_out_done(&p->link.out)) {
            return status;
        }
        status = deliver(d, is_up, f);
        if (status != DISPLAY_OK) {
            return status;
        }
        wire_frames_show(&p->link.out, p->link.frame.rgb, 3 * d->width);
    }
}

/* A picture that is shown anew without a change is one tile, the next of all (WIRE.md, section 5).
 */
static void renew(planelet *p) {
    if (clock_ms() - p->renewed >= RENEW_MS && wire_frames_out_done(&p->link.out)) {
        p->renewed = clock_ms();
        wire_frames_show(&p->link.out, p->link.frame.rgb, 3 * p->link.frame.width);
    }
}

static int planelet_tick(display *d) {
    int sent = 1;
    const uint32_t began = clock_ms();
    renew(d->state);
    while (sent && clock_ms() - began < TICK_MS && !display_is_stopped(d)) {
        if (exchange(d, 0, &sent) != PORT_OK) {
            return DISPLAY_GONE;
        }
    }
    return DISPLAY_OK;
}

static int planelet_brightness(display *d, unsigned percent, fail *f) {
    planelet *p = d->state;
    if (!(wire_other(&p->link.peer)->features & WIRE_BRIGHTNESS)) {
        return fail_set(f, NULL, "this display's brightness cannot be set; leave out --brightness");
    }
    wire_setting_send(&p->link.peer, WIRE_SET_BRIGHTNESS, percent);
    return DISPLAY_OK;
}

static void planelet_near(display *d, unsigned steps, unsigned fps) {
    planelet *p = d->state;
    if (steps == DISPLAY_NEAR_AUTO) {
        wire_frames_rate(&p->link.out, fps);
    } else {
        wire_frames_near(&p->link.out, steps);
    }
}

const driver driver_planelet = {.name = "planelet",
                                .about = "Planelet's own wire, any size (platform/WIRE.md)",
                                .ids = planelet_ids,
                                .keys = planelet_keys,
                                .open = planelet_open,
                                .show = planelet_show,
                                .renews = 1,
                                .confirm = planelet_confirm,
                                .tick = planelet_tick,
                                .brightness = planelet_brightness,
                                .near = planelet_near,
                                .close = planelet_close};
