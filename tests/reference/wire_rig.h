/* wire_rig - a host that shows frames, a display, and the cable between them
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_WIRE_RIG_H
#define REFERENCE_WIRE_RIG_H

#include "tests/reference/wire_fake.h"

enum { RIG_FRAMES = 64 };

typedef struct rig_shape {
    unsigned width, height, format, out_bytes, in_bytes, credits;
    int reads; /* the panel is memory; else rows go to a display controller */
} rig_shape;

typedef struct wire_rig {
    rig_shape shape;
    wire_peer host, device;
    wire_frames_out out;
    wire_frames_in in;
    fake_cable cable;
    uint8_t *panel, *reference; /* from malloc */
    uint8_t *rgb, *spare;       /* a frame that may be on its way, and one to draw the next into */
    uint8_t *shown[RIG_FRAMES]; /* every frame shown, in the panel's format */
    uint32_t stride, panel_bytes, frames;
    uint32_t wrong_rows, rows; /* rows that no frame ever had */
    uint32_t hosts, devices;   /* times each was started */
} wire_rig;

void wire_rig_open(wire_rig *r, rig_shape shape, uint64_t seed);
void wire_rig_close(wire_rig *r);

/* Power-cycles a peer: its memory is as after a reset; the panel stays. */
void wire_rig_start_host(wire_rig *r);
void wire_rig_start_device(wire_rig *r);

/* Draws the next frame into rgb: `kind` 0 shapes on a ramp that move, 1 noise, 2 few pixels. */
void wire_rig_draw(wire_rig *r, int kind);

/* Shows rgb and remembers it; 0 when there is no session. At most RIG_FRAMES. */
int wire_rig_show(wire_rig *r);

/* Steps until every tile is acknowledged; the milliseconds, or -1 after `most`. */
int wire_rig_wait(wire_rig *r, uint32_t most);

/* Bytes of the panel that differ from the last frame shown. */
uint32_t wire_rig_differences(const wire_rig *r);

/* Rows of tiles on the panel that are of no frame ever shown (and not blank). */
uint32_t wire_rig_strangers(const wire_rig *r);

#endif
