/* planelet_link - this end of the wire to a Planelet display, as far as nobody has to wait
 *
 * For both drivers of the wire: driver_planelet, and the page's, which must not wait. Each says in
 * words of its own what is wrong.
 *
 * Keeps: `frame` is what the wire reads, and changes only when the wire has put all of it into
 * reports.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_PLANELET_LINK_H
#define HID_PLANELET_LINK_H

#include "host_tools/hid/device/display.h"
#include "platform/wire/wire.h"

extern const display_key planelet_keys[]; /* in the order of enum wire_key */
extern const driver_id planelet_ids[];

typedef struct planelet_link {
    wire_peer peer;
    wire_frames_out out;
    wire_keys_in keys;
    picture frame; /* of the panel's size; owned by the driver */
    uint8_t report[1 + WIRE_REPORT_BYTES_MAX];
} planelet_link;

/* Begins to ask for a session. Sizes that are not known become 64 bytes; -1: reports of `sizes` are
 * none of a Planelet display, or longer than `in_most`. */
int planelet_link_open(planelet_link *l, report_sizes *sizes, unsigned in_most);

/* A report that came; what it says of keys is in `d->keys`. */
void planelet_link_take(planelet_link *l, display *d, const uint8_t *report, size_t bytes);

/* Sends the next report, if one may go. Returns a port_status. */
int planelet_link_send(planelet_link *l, port *to, int *sent);

/* Of the display that has answered: whether it has a panel, and the wire can keep its tiles. */
enum planelet_panel { PLANELET_PANEL, PLANELET_NO_PANEL, PLANELET_PANEL_TOO_LARGE };
enum planelet_panel planelet_link_panel(const planelet_link *l, unsigned *tiles);

/* The picture of the panel's size goes to the wire. Returns a wire_status. */
int planelet_link_show(planelet_link *l, const picture *p);

#endif
