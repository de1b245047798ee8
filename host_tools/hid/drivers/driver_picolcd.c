/* driver_picolcd - Mini-Box picoLCD 256x64: four controllers side by side
 *
 * Each has 64 columns in eight pages (pages.h). Output reports of 64 bytes,
 * their number among them, start a controller and set one of its pages, in
 * two halves of 32 columns:
 *
 *     0  94  chip * 4  02 00 64 3F 00 64 C0          at the start
 *     0  96  chip * 4  02 00 00 B8 + page 00 00 40 00 00 20   12  32 bytes
 *     0  95  chip * 4 + 1  00 00 20                            5  32 bytes
 *
 * Only pages that changed since the last picture are sent. Brightness, 0 to
 * 255, is output report 91 of 2 bytes. Input report 11 has the numbers of up to
 * two keys that are down, of a matrix of which five are there. Where the system has its
 * own driver for this display (hid-picolcd of Linux), that has to let go of it first.
 *
 * Source: hid-picolcd of the Linux kernel (B. Premont), facts only. Not run on
 * hardware.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/hid/drivers/pages.h"

enum {
    CHIPS = 4,
    PAGES = 8,
    COLUMNS = 64, /* of a chip */
    HALF = COLUMNS / 2,
    REPORT_BYTES = 64,
    BRIGHTNESS = 0x91,
    COMMAND = 0x94,
    DATA = 0x95,
    COMMAND_DATA = 0x96,
    INPUT = 0x11
};

typedef struct picolcd {
    uint8_t shown[CHIPS][PAGES][COLUMNS];
    uint8_t known[CHIPS][PAGES]; /* what is `shown` is on the panel */
} picolcd;

static int send(display *d, const uint8_t report[REPORT_BYTES]) {
    const int status = port_output(d->port, report, REPORT_BYTES);
    return status != PORT_OK       ? display_status(status)
           : display_is_stopped(d) ? DISPLAY_STOPPED
                                   : DISPLAY_OK;
}

static int send_page(display *d, unsigned chip, unsigned page, const uint8_t *columns) {
    uint8_t first[REPORT_BYTES] = {
        COMMAND_DATA, (uint8_t)(chip << 2), 2, 0, 0, (uint8_t)(0xB8 | page), 0, 0, 0x40, 0, 0,
        HALF};
    uint8_t second[REPORT_BYTES] = {DATA, (uint8_t)(chip << 2 | 1), 0, 0, HALF};
    memcpy(first + 12, columns, HALF);
    memcpy(second + 5, columns + HALF, HALF);
    const int status = send(d, first);
    return status != DISPLAY_OK ? status : send(d, second);
}

static int picolcd_show(display *d, const picture *p, fail *f) {
    picolcd *l = d->state;
    (void)f;
    for (unsigned i = 0; i < CHIPS * PAGES; i++) {
        const unsigned chip = i / PAGES, page = i % PAGES;
        uint8_t columns[COLUMNS];
        pages_columns(p, page, chip * COLUMNS, COLUMNS, columns);
        if (l->known[chip][page] && memcmp(columns, l->shown[chip][page], COLUMNS) == 0) {
            continue;
        }
        l->known[chip][page] = 0;
        const int status = send_page(d, chip, page, columns);
        if (status != DISPLAY_OK) {
            return status;
        }
        memcpy(l->shown[chip][page], columns, COLUMNS);
        l->known[chip][page] = 1;
    }
    return DISPLAY_OK;
}

static void picolcd_forget(display *d, unsigned piece) {
    picolcd *l = d->state;
    l->known[piece / PAGES][piece % PAGES] = 0;
}

static int picolcd_brightness(display *d, unsigned percent, fail *f) {
    const uint8_t report[2] = {BRIGHTNESS, (uint8_t)((percent * 255 + 50) / 100)};
    (void)f;
    return display_status(port_output(d->port, report, sizeof report));
}

static const display_key keys[] = {{"back", STEER_FARTHER, 0, 0},      {"home", STEER_RESET, 0, 0},
                                   {"scroll up", STEER_LEFT, 0, 0},    {"OK", STEER_NEARER, 0, 0},
                                   {"scroll down", STEER_RIGHT, 0, 0}, {NULL, STEER_LEFT, 0, 0}};
static const uint8_t key_numbers[] = {1, 2, 5, 6, 7}; /* of `keys` */

static void take_report(display *d, const uint8_t *report, size_t bytes) {
    if (bytes >= 3 && report[0] == INPUT) {
        for (unsigned key = 0; key < sizeof key_numbers; key++) {
            keys_set(&d->keys, key, report[1] == key_numbers[key] || report[2] == key_numbers[key]);
        }
    }
}

static int picolcd_tick(display *d) {
    return display_hear(d, take_report);
}

static void picolcd_close(display *d) {
    free(d->state);
    d->state = NULL;
}

static int picolcd_open(display *d, fail *f) {
    d->width = CHIPS * COLUMNS;
    d->height = 8 * PAGES;
    d->pieces = CHIPS * PAGES;
    d->state = calloc(1, sizeof(picolcd));
    if (d->state == NULL) {
        return fail_set(f, NULL, "out of memory; close other programs");
    }
    int status = DISPLAY_OK;
    for (unsigned chip = 0; chip < CHIPS && status == DISPLAY_OK; chip++) {
        const uint8_t report[REPORT_BYTES] = {
            COMMAND, (uint8_t)(chip << 2), 2, 0, 0x64, 0x3F, 0, 0x64, 0xC0};
        status = send(d, report);
    }
    if (status != DISPLAY_OK) {
        picolcd_close(d);
    }
    return status;
}

static const driver_id ids[] = {{0x04D8, 0xC002, 0}, {0, 0, 0}};

const driver driver_picolcd = {.name = "picolcd",
                               .about = "Mini-Box picoLCD 256x64, 1 bit",
                               .ids = ids,
                               .from_notes = 1,
                               .open = picolcd_open,
                               .show = picolcd_show,
                               .forget = picolcd_forget,
                               .tick = picolcd_tick,
                               .keys = keys,
                               .brightness = picolcd_brightness,
                               .close = picolcd_close};
