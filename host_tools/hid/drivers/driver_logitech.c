/* driver_logitech - the panels of Logitech's G13, G15, G510, Z-10 and of the Gamepanel
 *
 * 160x43 pixels of one bit in one output report of 992 bytes: 03, 31 zeros,
 * then six pages of 160 bytes (pages.h), the last of which has three rows.
 * A keyboard has other interfaces beside; of those that are not known to
 * matter the first is used.
 *
 * Below the panel is a row of four keys, beside it a round one. Input reports
 * have a bit for each, which are known by number and size:
 *
 *     01, 8 bytes    G13: byte 6, bit 0 the round one, 1 .. 4 the row; bytes 1 and
 *                    2 are its stick's column and row, 128 in the middle
 *     02, 9 bytes    G15 v1: bit 7 of byte 8, and of bytes 2 .. 5
 *     02, 5 bytes    G15 v2, Z-10, Gamepanel: byte 2, bit 7, and 1 .. 4
 *     03, 5 bytes    G510: byte 4, bit 0, and 1 .. 4
 *
 * Sources: libg15 (the G15tools project; netfab), which lists the devices and
 * draws the layout; g13 (ecraven); hid-lg-g15 of the Linux kernel (H. de
 * Goede), which has the same keys but the Z-10's and Gamepanel's, facts only.
 * Not run on hardware.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/hid/drivers/pages.h"

enum { WIDTH = 160, HEIGHT = 43, PAGES = 6, HEAD_BYTES = 32, REPORT_BYTES = 992, NUMBER = 3 };

/* Entries of `keys`. */
enum { ROW, ROW_KEYS = 4, ROUND = ROW + ROW_KEYS, STICK };

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

static void take_stick(display *d, const uint8_t at[2]) {
    for (unsigned axis = 0; axis < 2; axis++) {
        keys_set(&d->keys, STICK + 2 * axis, at[axis] < 64);
        keys_set(&d->keys, STICK + 2 * axis + 1, at[axis] >= 192);
    }
}

/* The round key's byte and bit, and those of the row's first key; the next is in the next byte
 * (`by_bytes`), or bit. */
static void take_bits(display *d, const uint8_t *report, unsigned byte, unsigned bit,
                      unsigned row_byte, unsigned row_bit, int by_bytes) {
    keys_set(&d->keys, ROUND, report[byte] >> bit & 1);
    for (unsigned key = 0; key < ROW_KEYS; key++) {
        const unsigned at = row_byte + (by_bytes ? key : 0);
        keys_set(&d->keys, ROW + key, report[at] >> (row_bit + (by_bytes ? 0 : key)) & 1);
    }
}

static void take_report(display *d, const uint8_t *report, size_t bytes) {
    if (bytes == 8 && report[0] == 1) {
        take_bits(d, report, 6, 0, 6, 1, 0);
        take_stick(d, report + 1);
    } else if (bytes == 9 && report[0] == 2) {
        take_bits(d, report, 8, 7, 2, 7, 1);
    } else if (bytes == 5 && report[0] == 2) {
        take_bits(d, report, 2, 7, 2, 1, 0);
    } else if (bytes == 5 && report[0] == 3) {
        take_bits(d, report, 4, 0, 4, 1, 0);
    }
}

static int logitech_tick(display *d) {
    return display_hear(d, take_report);
}

static const display_key keys[] = {{"first below the panel", STEER_LEFT, 0, 0},
                                   {"second", STEER_RIGHT, 0, 0},
                                   {"third", STEER_NEARER, 0, 0},
                                   {"fourth", STEER_FARTHER, 0, 0},
                                   {"round, beside it", STEER_RESET, 0, 0},
                                   {"G13, stick left", STEER_LEFT, 0, 0},
                                   {"G13, stick right", STEER_RIGHT, 0, 0},
                                   {"G13, stick up", STEER_UP, 0, 0},
                                   {"G13, stick down", STEER_DOWN, 0, 0},
                                   {NULL, STEER_LEFT, 0, 0}};

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
                                .show = logitech_show,
                                .tick = logitech_tick,
                                .keys = keys};
