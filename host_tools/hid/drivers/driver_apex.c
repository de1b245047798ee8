/* driver_apex - SteelSeries Apex 5, 7 and Pro keyboards: a small OLED
 *
 * 128x40 pixels of one bit in one feature report of 642 bytes: 61, then rows
 * from top to bottom of 16 bytes, highest bit left, then 00. The 61 stands
 * where hidapi expects a report number, and the device wants it there.
 * (The third generation, 1038:1642 and on, has another protocol; this
 * driver is not for it.)
 *
 * Sources: steelseries-oled (edbgon), steelseries-apex-oled (jonkadelic),
 * OmniLED (llMBQll), facts only. Not run on hardware.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/drivers/drivers.h"
#include "platform/wire/wire_format.h"

enum { WIDTH = 128, HEIGHT = 40, FEATURE_BYTES = 1 + WIDTH / 8 * HEIGHT + 1, DRAW = 0x61 };

static int apex_show(display *d, const picture *p, fail *f) {
    uint8_t report[FEATURE_BYTES] = {DRAW};
    (void)f;
    for (unsigned y = 0; y < HEIGHT; y++) {
        wire_row_from_rgb(report + 1 + y * (WIDTH / 8), WIRE_MONO1, p->rgb + 3 * y * WIDTH, WIDTH,
                          0, y);
    }
    return display_status(port_feature(d->port, report, sizeof report));
}

static int apex_open(display *d, fail *f) {
    (void)f;
    d->width = WIDTH;
    d->height = HEIGHT;
    return DISPLAY_OK;
}

static const driver_id ids[] = {{0x1038, 0x161C, 1},
                                {0x1038, 0x1612, 1},
                                {0x1038, 0x1618, 1},
                                {0x1038, 0x1610, 1},
                                {0x1038, 0x1614, 1},
                                {0x1038, 0x1628, 1},
                                {0, 0, 0}};

const driver driver_apex = {.name = "apex",
                            .about = "SteelSeries Apex 5, 7 and Pro keyboards, 128x40, 1 bit",
                            .ids = ids,
                            .from_notes = 1,
                            .open = apex_open,
                            .show = apex_show};
