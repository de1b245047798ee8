/* planelet_link - see planelet_link.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/drivers/planelet_link.h"

#include <string.h>

#include "host_tools/base/clock.h"

enum { USUAL_BYTES = 64, WINDOW = 32 };

/* Without symbols: what a key looks like is the device's. */
const display_key planelet_keys[] = {
    {"left", STEER_LEFT, 0, 0},   {"right", STEER_RIGHT, 0, 0},   {"up", STEER_UP, 0, 0},
    {"down", STEER_DOWN, 0, 0},   {"nearer", STEER_NEARER, 0, 0}, {"farther", STEER_FARTHER, 0, 0},
    {"reset", STEER_RESET, 0, 0}, {"still", STEER_STILL, 0, 0},   {NULL, STEER_LEFT, 0, 0}};
_Static_assert((int)STEER_STILL == (int)WIRE_KEY_STILL, "keys of the wire and of a scene");
_Static_assert((int)WIRE_KEYS_MOST <= (int)KEYS_MOST, "all keys of the wire are heard");

/* pid.codes reserves 1209:0001 for tests; a product needs an id of its own. */
const driver_id planelet_ids[] = {{0x1209, 0x0001, 0}, {0, 0, 0}};

/* A number that no session had before: the time of day in microseconds. */
static uint32_t session_number(void) {
    return (uint32_t)clock_day_us();
}

int planelet_link_open(planelet_link *l, report_sizes *sizes, unsigned in_most) {
    sizes->out = sizes->out > 0 ? sizes->out : USUAL_BYTES;
    sizes->in = sizes->in > 0 ? sizes->in : USUAL_BYTES;
    if (sizes->in > in_most || sizes->out > WIRE_REPORT_BYTES_MAX) {
        return -1;
    }
    const wire_setup setup = {.role = WIRE_HOST,
                              .caps = {.session = session_number(),
                                       .in_bytes = (uint16_t)sizes->in,
                                       .out_bytes = (uint16_t)sizes->out,
                                       .features = WIRE_SENDS,
                                       .credits = WINDOW}};
    if (wire_peer_open(&l->peer, &setup, clock_ms()) != WIRE_OK) {
        return -1;
    }
    wire_frames_out_open(&l->out, &l->peer);
    wire_keys_in_open(&l->keys, &l->peer);
    wire_on_link(&l->peer, 1, clock_ms());
    return 0;
}

void planelet_link_take(planelet_link *l, display *d, const uint8_t *report, size_t bytes) {
    wire_on_report(&l->peer, report, bytes, clock_ms());
    memcpy(d->keys.changes, l->keys.changes, sizeof l->keys.changes);
}

int planelet_link_send(planelet_link *l, port *to, int *sent) {
    const size_t bytes = wire_next_report(&l->peer, l->report + 1, clock_ms());
    *sent = bytes > 0;
    l->report[0] = 0; /* these reports have no number */
    return bytes > 0 ? port_output(to, l->report, bytes + 1) : PORT_OK;
}

enum planelet_panel planelet_link_panel(const planelet_link *l, unsigned *tiles) {
    const wire_caps *other = wire_other(&l->peer);
    *tiles = (other->width + 15u) / 16 * ((other->height + 15u) / 16);
    return !(other->features & WIRE_SHOWS) ? PLANELET_NO_PANEL
           : *tiles > WIRE_TILES_MAX       ? PLANELET_PANEL_TOO_LARGE
                                           : PLANELET_PANEL;
}

int planelet_link_show(planelet_link *l, const picture *p) {
    memcpy(l->frame.rgb, p->rgb, 3 * (size_t)p->width * p->height);
    return wire_frames_show(&l->out, l->frame.rgb, 3 * p->width);
}
