/* driver_apex_2023 - SteelSeries Apex Pro TKL of 2023: the OLED of an Apex, told otherwise
 *
 * 128x40 pixels of one bit in one feature report of 644 bytes: 1F 81, then
 * five pages of 128 bytes (pages.h), then 00 00. Reports have no number, so
 * hidapi gets a 0 first.
 *
 * Sources: steelclock-go (pozitronik), a pull request with a capture of this
 * keyboard's own program (1038:1628); steelseries-oled (DreamTimeZ), notes on
 * the same report of a later keyboard, facts only. Not run on hardware.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/hid/drivers/pages.h"

enum { WIDTH = 128, PAGES = 5, HEAD_BYTES = 3, FEATURE_BYTES = 1 + 644 };

static int apex_2023_show(display *d, const picture *p, fail *f) {
    uint8_t report[FEATURE_BYTES] = {0, 0x1F, 0x81};
    (void)f;
    for (unsigned page = 0; page < PAGES; page++) {
        pages_columns(p, page, 0, WIDTH, report + HEAD_BYTES + page * WIDTH);
    }
    return display_status(port_feature(d->port, report, sizeof report));
}

static int apex_2023_open(display *d, fail *f) {
    (void)f;
    d->width = WIDTH;
    d->height = 8 * PAGES;
    return DISPLAY_OK;
}

static const driver_id ids[] = {{0x1038, 0x1628, 1}, {0, 0, 0}};

const driver driver_apex_2023 = {.name = "apex-2023",
                                 .about = "SteelSeries Apex Pro TKL (2023), 128x40, 1 bit",
                                 .ids = ids,
                                 .from_notes = 1,
                                 .open = apex_2023_open,
                                 .show = apex_2023_show};
