/* driver_nexus - Corsair iCUE Nexus: a strip of 640x48 above a keyboard
 *
 * Raw pixels of four bytes, blue green red and one not used, rows top down,
 * in 121 output reports of 1024 bytes:
 *
 *     0  02 05 40    report number, command
 *     3  last        1 in the last report: the panel then changes
 *     4  part        u16, 0 .. 120
 *     6  length      u16, bytes of pixels: 1016, 960 in the last
 *     8  pixels
 *
 * The panel keeps 6 bits of a colour, so the lower two come from a dither
 * (picture/dither.h). Numbers are little-endian. Feature report 3, of 32 bytes,
 * is brightness (03 01, percent) or gives the panel back to the device's own
 * picture (03 0D 01 01), which keeps the brightness that it had here, so that
 * is set to 100.
 * The second interface is a keyboard; the driver is not for it.
 *
 * The panel is touched at a column, not a row. Input reports of 512 bytes come a hundred
 * times per second:
 *
 *     0  01 02 21    5  1 while a finger is there    6  u16, its column
 *
 * A swift finger is lost for a report now and then, which has 0 but still a column;
 * when it has left, the column is 0, too. A scene goes with a finger that moves, and
 * a tap is nearer, farther or the first view again.
 *
 * Source: Nexus-Manager (codingncaffeine), its wiki and notes, facts only. Not run
 * on hardware.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/picture/dither.h"

enum {
    WIDTH = 640,
    HEIGHT = 48,
    FRAME_BYTES = 4 * WIDTH * HEIGHT,
    REPORT_BYTES = 1024,
    HEAD_BYTES = 8,
    PART_BYTES = REPORT_BYTES - HEAD_BYTES,
    FEATURE_BYTES = 32,
    INPUT = 1, /* number of the report */
    INPUT_BYTES = 8,
    STEP = 32 /* columns that a finger moves for a step; less is a tap */
};

enum { SWIPE, TAP = 2 }; /* entries of `keys`: two, and three */

typedef struct nexus {
    int is_touched, is_swipe;
    int column; /* up to which the finger's way has been taken */
} nexus;

static uint8_t frame_byte(const picture *p, unsigned at) {
    const uint8_t *rgb = p->rgb + 3 * (size_t)(at / 4);
    const unsigned pixel = at / 4;
    return at % 4 == 3 ? 0 : dither_six_bits(rgb[2 - at % 4], pixel % WIDTH, pixel / WIDTH);
}

static int send_part(port *to, const picture *p, unsigned part) {
    const unsigned at = part * PART_BYTES, left = FRAME_BYTES - at;
    const unsigned bytes = left < PART_BYTES ? left : PART_BYTES;
    uint8_t report[REPORT_BYTES] = {2,
                                    5,
                                    0x40,
                                    left <= PART_BYTES,
                                    (uint8_t)part,
                                    (uint8_t)(part >> 8),
                                    (uint8_t)bytes,
                                    (uint8_t)(bytes >> 8)};
    for (unsigned i = 0; i < bytes; i++) {
        report[HEAD_BYTES + i] = frame_byte(p, at + i);
    }
    return port_output(to, report, sizeof report);
}

static int nexus_show(display *d, const picture *p, fail *f) {
    int status = PORT_OK;
    (void)f;
    for (unsigned part = 0; part * PART_BYTES < FRAME_BYTES && status == PORT_OK; part++) {
        status = send_part(d->port, p, part);
        if (display_is_stopped(d)) {
            return DISPLAY_STOPPED;
        }
    }
    return display_status(status);
}

static int nexus_brightness(display *d, unsigned percent, fail *f) {
    const uint8_t report[FEATURE_BYTES] = {3, 1, (uint8_t)percent};
    (void)f;
    return display_status(port_feature(d->port, report, sizeof report));
}

static int nexus_release(display *d, fail *f) {
    const uint8_t report[FEATURE_BYTES] = {3, 0x0D, 1, 1};
    const int status = display_status(port_feature(d->port, report, sizeof report));
    return status == DISPLAY_OK ? nexus_brightness(d, 100, f) : status;
}

static void take_finger(display *d, int column) {
    nexus *n = d->state;
    if (!n->is_touched) {
        *n = (nexus){.is_touched = 1, .column = column};
    }
    const int steps = (column - n->column) / STEP;
    n->is_swipe |= steps != 0;
    n->column += steps * STEP;
    keys_step(&d->keys, SWIPE + (steps > 0), (unsigned)(steps < 0 ? -steps : steps));
}

static void take_report(display *d, const uint8_t *report, size_t bytes) {
    nexus *n = d->state;
    if (bytes < INPUT_BYTES || report[0] != INPUT || report[1] != 2) {
        return;
    }
    const int said = report[6] | report[7] << 8, column = said < WIDTH ? said : WIDTH - 1;
    if (report[5] != 0 || column != 0) {
        take_finger(d, column);
    } else if (n->is_touched) {
        n->is_touched = 0;
        if (!n->is_swipe) {
            keys_step(&d->keys, TAP + 3 * (unsigned)n->column / WIDTH, 1);
        }
    }
}

static int nexus_tick(display *d) {
    return display_hear(d, take_report);
}

static int nexus_open(display *d, fail *f) {
    d->width = WIDTH;
    d->height = HEIGHT;
    d->state = calloc(1, sizeof(nexus));
    return d->state != NULL ? DISPLAY_OK : fail_set(f, NULL, "out of memory; close other programs");
}

static void nexus_close(display *d) {
    free(d->state);
    d->state = NULL;
}

static const display_key keys[] = {
    {"swipe to the left", STEER_RIGHT, 0, 0}, {"swipe to the right", STEER_LEFT, 0, 0},
    {"tap, left third", STEER_FARTHER, 0, 0}, {"tap, middle", STEER_RESET, 0, 0},
    {"tap, right third", STEER_NEARER, 0, 0}, {NULL, STEER_LEFT, 0, 0}};

static const driver_id ids[] = {{0x1B1C, 0x1B8E, 0}, {0, 0, 0}};

const driver driver_nexus = {.name = "nexus",
                             .about = "Corsair iCUE Nexus, 640x48",
                             .ids = ids,
                             .from_notes = 1,
                             .open = nexus_open,
                             .show = nexus_show,
                             .tick = nexus_tick,
                             .keys = keys,
                             .brightness = nexus_brightness,
                             .release = nexus_release,
                             .close = nexus_close};
