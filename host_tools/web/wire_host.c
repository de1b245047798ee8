/* wire_host - see wire_host.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/web/wire_host.h"

#include "host_tools/base/clock.h"
#include "host_tools/hid/drivers/planelet_link.h"

enum { ANSWER_MS = 3000, FRAMES_PER_SECOND = 12 };

typedef struct wire_host {
    planelet_link link;
    uint32_t begun; /* ms */
    fail why;       /* driver.tick has none */
} wire_host;

static wire_host host; /* the page has one display at a time */

const fail *wire_host_why(void) {
    return &host.why;
}

int wire_host_is_done(void) {
    return wire_frames_out_done(&host.link.out);
}

int wire_host_is_idle(void) {
    return wire_is_up(&host.link.peer) && wire_frames_out_idle(&host.link.out);
}

static int wire_host_open(display *d, fail *f) {
    report_sizes sizes = d->reports;
    if (planelet_link_open(&host.link, &sizes, WIRE_REPORT_BYTES_MAX) != 0) {
        return fail_set(f, "display",
                        "reports of %u bytes out and %u in are none of a Planelet display; connect "
                        "another device",
                        sizes.out, sizes.in);
    }
    host.begun = clock_ms();
    host.why.text[0] = '\0';
    host.link.frame = (picture){NULL, 0, 0};
    d->state = &host;
    wire_frames_rate(&host.link.out, FRAMES_PER_SECOND);
    return DISPLAY_OK;
}

/* The display has answered: its panel, if it has one. After a reset it may answer as another, and
 * then more would be read of `frame` than there is. */
static int greet(display *d, fail *f) {
    const wire_caps *peer = wire_other(&host.link.peer);
    if (d->width > 0 && d->width == peer->width && d->height == peer->height) {
        return DISPLAY_OK;
    }
    if (d->width > 0) {
        return fail_set(f, "display", "it changed its size to %u x %u pixels; connect it again",
                        peer->width, peer->height);
    }
    unsigned tiles;
    if (planelet_link_panel(&host.link, &tiles) != PLANELET_PANEL) {
        return fail_set(f, "display",
                        "it has a panel of %u x %u pixels, up to %u tiles of 16 x 16 can be shown; "
                        "connect another device",
                        peer->width, peer->height, (unsigned)WIRE_TILES_MAX);
    }
    d->width = peer->width;
    d->height = peer->height;
    return picture_make(&host.link.frame, d->width, d->height, f);
}

static int take_input(display *d) {
    uint8_t report[WIRE_REPORT_BYTES_MAX];
    int bytes;
    while ((bytes = port_input(d->port, report, sizeof report, 0)) > 0) {
        planelet_link_take(&host.link, d, report, (size_t)bytes);
    }
    return bytes == 0 ? DISPLAY_OK : DISPLAY_GONE;
}

static int send_all(display *d) {
    int sent = 1;
    while (sent) {
        if (planelet_link_send(&host.link, d->port, &sent) != PORT_OK) {
            return DISPLAY_GONE;
        }
    }
    return DISPLAY_OK;
}

static int wire_host_tick(display *d) {
    int status = take_input(d);
    wire_poll(&host.link.peer, clock_ms());
    if (status == DISPLAY_OK && wire_is_up(&host.link.peer)) {
        status = greet(d, &host.why);
    }
    if (status == DISPLAY_OK && d->width == 0 && clock_ms() - host.begun > ANSWER_MS) {
        return DISPLAY_GONE;
    }
    return status == DISPLAY_OK ? send_all(d) : status;
}

static int wire_host_show(display *d, const picture *shown, fail *f) {
    (void)f;
    if (!wire_host_is_idle()) {
        return DISPLAY_OK; /* the page asks again */
    }
    planelet_link_show(&host.link, shown);
    return send_all(d);
}

static void wire_host_close(display *d) {
    picture_free(&host.link.frame);
    d->state = NULL;
}

const driver driver_wire_host = {.name = "planelet",
                                 .about = "Planelet display",
                                 .ids = planelet_ids,
                                 .keys = planelet_keys,
                                 .open = wire_host_open,
                                 .show = wire_host_show,
                                 .tick = wire_host_tick,
                                 .close = wire_host_close};
