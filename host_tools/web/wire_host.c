/* wire_host - see wire_host.h
 *
 * Keeps: `frame` is what the wire reads, and changes only when the wire has put all of it into
 * reports.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/web/wire_host.h"

#include <string.h>

#include "host_tools/base/clock.h"
#include "host_tools/hid/drivers/planelet_keys.h"
#include "platform/wire/wire.h"

enum { ANSWER_MS = 3000, WINDOW = 32, FRAMES_PER_SECOND = 12, IN_BYTES_USUAL = 64 };

typedef struct wire_host {
    wire_peer peer;
    wire_frames_out out;
    wire_keys_in keys;
    picture frame;
    uint32_t begun; /* ms */
    fail why;       /* driver.tick has none */
    uint8_t report[1 + WIRE_REPORT_BYTES_MAX];
} wire_host;

static wire_host host; /* the page has one display at a time */

const fail *wire_host_why(void) {
    return &host.why;
}

int wire_host_is_done(void) {
    return wire_frames_out_done(&host.out);
}

int wire_host_is_idle(void) {
    return wire_is_up(&host.peer) && wire_frames_out_idle(&host.out);
}

static int wire_host_open(display *d, fail *f) {
    const unsigned out = d->reports.out > 0 ? d->reports.out : IN_BYTES_USUAL;
    const unsigned in = d->reports.in > 0 ? d->reports.in : IN_BYTES_USUAL;
    const wire_setup setup = {.role = WIRE_HOST,
                              .caps = {.session = (uint32_t)clock_day_us(),
                                       .in_bytes = (uint16_t)in,
                                       .out_bytes = (uint16_t)out,
                                       .features = WIRE_SENDS,
                                       .credits = WINDOW}};
    if (out > WIRE_REPORT_BYTES_MAX || wire_peer_open(&host.peer, &setup, clock_ms()) != WIRE_OK) {
        return fail_set(f, "display",
                        "reports of %u bytes out and %u in are none of a Planelet display; connect "
                        "another device",
                        out, in);
    }
    host.begun = clock_ms();
    host.why.text[0] = '\0';
    host.frame = (picture){NULL, 0, 0};
    d->state = &host;
    wire_frames_out_open(&host.out, &host.peer);
    wire_frames_rate(&host.out, FRAMES_PER_SECOND);
    wire_keys_in_open(&host.keys, &host.peer);
    wire_on_link(&host.peer, 1, clock_ms());
    return DISPLAY_OK;
}

/* The display has answered: its panel, if it has one. After a reset it may answer as another, and
 * then more would be read of `frame` than there is. */
static int greet(display *d, fail *f) {
    const wire_caps *peer = wire_other(&host.peer);
    if (d->width > 0 && d->width == peer->width && d->height == peer->height) {
        return DISPLAY_OK;
    }
    if (d->width > 0) {
        return fail_set(f, "display", "it changed its size to %u x %u pixels; connect it again",
                        peer->width, peer->height);
    }
    const unsigned tiles = (peer->width + 15u) / 16 * ((peer->height + 15u) / 16);
    if (!(peer->features & WIRE_SHOWS) || tiles == 0 || tiles > WIRE_TILES_MAX) {
        return fail_set(f, "display",
                        "it has a panel of %u x %u pixels, up to %u tiles of 16 x 16 can be shown; "
                        "connect another device",
                        peer->width, peer->height, (unsigned)WIRE_TILES_MAX);
    }
    d->width = peer->width;
    d->height = peer->height;
    return picture_make(&host.frame, d->width, d->height, f);
}

static int take_input(display *d) {
    uint8_t report[WIRE_REPORT_BYTES_MAX];
    int bytes;
    while ((bytes = port_input(d->port, report, sizeof report, 0)) > 0) {
        wire_on_report(&host.peer, report, (size_t)bytes, clock_ms());
        memcpy(d->keys.changes, host.keys.changes, sizeof host.keys.changes);
    }
    return bytes == 0 ? DISPLAY_OK : DISPLAY_GONE;
}

static int send_all(display *d) {
    size_t bytes;
    host.report[0] = 0; /* these reports have no number */
    while ((bytes = wire_next_report(&host.peer, host.report + 1, clock_ms())) > 0) {
        if (port_output(d->port, host.report, bytes + 1) != PORT_OK) {
            return DISPLAY_GONE;
        }
    }
    return DISPLAY_OK;
}

static int wire_host_tick(display *d) {
    int status = take_input(d);
    wire_poll(&host.peer, clock_ms());
    if (status == DISPLAY_OK && wire_is_up(&host.peer)) {
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
    memcpy(host.frame.rgb, shown->rgb, (size_t)3 * d->width * d->height);
    wire_frames_show(&host.out, host.frame.rgb, 3 * d->width);
    return send_all(d);
}

static void wire_host_close(display *d) {
    picture_free(&host.frame);
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
