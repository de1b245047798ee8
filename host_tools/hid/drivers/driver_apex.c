/* driver_apex - SteelSeries Apex 5, 7 and Pro keyboards: a small OLED
 *
 * 128x40 pixels of one bit in one feature report of 642 bytes: 61, then rows
 * from top to bottom of 16 bytes, highest bit left, then 00. Reports have no
 * number (SET_REPORT goes out with a value of 0300), so hidapi gets a 0 first.
 *
 * The Apex Pro TKL of 2023 accepts such a report and shows nothing: it has a
 * driver of its own, driver_apex_2023.c. The third generation (1038:1642 and
 * on) is in neither: of three projects each has another protocol for it.
 *
 * Sources: OmniLED (llMBQll), which gives the request that goes out;
 * steelseries-oled (edbgon), steelseries-apex-oled (jonkadelic), facts only.
 * Not run on hardware.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/picture/dither.h"

enum { WIDTH = 128, HEIGHT = 40, HEAD_BYTES = 2, FEATURE_BYTES = 1 + 642, DRAW = 0x61 };

static int apex_show(display *d, const picture *p, fail *f) {
    uint8_t report[FEATURE_BYTES] = {0, DRAW};
    (void)f;
    for (unsigned i = 0; i < WIDTH * HEIGHT; i++) {
        if (dither_is_lit(p->rgb + 3 * i, i % WIDTH, i / WIDTH)) {
            report[HEAD_BYTES + i / 8] |= (uint8_t)(0x80 >> i % 8);
        }
    }
    return display_status(port_feature(d->port, report, sizeof report));
}

static int apex_open(display *d, fail *f) {
    (void)f;
    d->width = WIDTH;
    d->height = HEIGHT;
    return DISPLAY_OK;
}

static const driver_id ids[] = {{0x1038, 0x161C, 1}, {0x1038, 0x1612, 1}, {0x1038, 0x1618, 1},
                                {0x1038, 0x1610, 1}, {0x1038, 0x1614, 1}, {0, 0, 0}};

const driver driver_apex = {.name = "apex",
                            .about = "SteelSeries Apex 5, 7 and Pro keyboards, 128x40, 1 bit",
                            .ids = ids,
                            .from_notes = 1,
                            .open = apex_open,
                            .show = apex_show};
