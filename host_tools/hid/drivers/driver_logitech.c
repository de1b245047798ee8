/* driver_logitech - the panels of Logitech's G13, G15, G510, Z-10 and of the Gamepanel
 *
 * 160x43 pixels of one bit in one output report of 992 bytes: 03, 31 zeros,
 * then six pages of 160 bytes (pages.h), the last of which has three rows.
 * A keyboard has other interfaces beside; of those that are not known to
 * matter the first is used.
 *
 * Sources: libg15 (the G15tools project; netfab), which lists the devices and
 * draws the layout; g13 (ecraven), facts only. Not run on hardware.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/hid/drivers/pages.h"

enum { WIDTH = 160, HEIGHT = 43, PAGES = 6, HEAD_BYTES = 32, REPORT_BYTES = 992, NUMBER = 3 };

static int logitech_show(display *d, const picture *p, fail *f) {
    uint8_t report[REPORT_BYTES] = {NUMBER};
    (void)f;
    for (unsigned page = 0; page < PAGES; page++) {
        pages_columns(p, page, 0, WIDTH, report + HEAD_BYTES + page * WIDTH);
    }
    return display_status(port_output(d->port, report, sizeof report));
}

static int logitech_open(display *d, fail *f) {
    (void)f;
    d->width = WIDTH;
    d->height = HEIGHT;
    return DISPLAY_OK;
}

static const driver_id ids[] = {{0x046D, 0xC21C, 0},
                                {0x046D, 0xC222, DRIVER_ANY_INTERFACE},
                                {0x046D, 0xC227, DRIVER_ANY_INTERFACE},
                                {0x046D, 0x0A07, DRIVER_ANY_INTERFACE},
                                {0x046D, 0xC251, DRIVER_ANY_INTERFACE},
                                {0x046D, 0xC22D, 1},
                                {0x046D, 0xC22E, 1},
                                {0, 0, 0}};

const driver driver_logitech = {.name = "logitech",
                                .about =
                                    "Logitech G13, G15, G510, Z-10 and Gamepanel, 160x43, 1 bit",
                                .ids = ids,
                                .from_notes = 1,
                                .open = logitech_open,
                                .show = logitech_show};
