/* driver_streamdeck_original - Elgato's first Stream Deck: 15 keys over one panel
 *
 * The keys are used as one picture of 360x216 without gaps, key 0 top left. The
 * device counts the keys of a row from the right, and each shows its image
 * mirrored: a BMP file of 72x72 pixels of 24 bits whose first row, read in the
 * order of its bytes, is the key's top row from right to left. It goes in two
 * output reports of 8191 bytes, half of the file in each:
 *
 *     0  02 01     report number, command
 *     2  page      1, 2
 *     4  last      1 in the second
 *     5  key + 1   4 top left, 0 top right, 10 bottom right
 *     16 7803 bytes of the file, zeros after them
 *
 * A report of 02 and zeros ends an image that another program did not send to
 * its end. Brightness, reset and the keys' input reports are those of a Mini
 * (driver_streamdeck_mini.c), keys counted from the right.
 *
 * Sources: the npm package @elgato-stream-deck/core 7.6.3 (J. Waller);
 * python-elgato-streamdeck (D. Camera), facts only. Not run on hardware.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "host_tools/hid/drivers/deck_keys.h"
#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/hid/drivers/key_bmp.h"

enum {
    SIDE = 72,
    COLUMNS = 5,
    ROWS = 3,
    KEYS = COLUMNS * ROWS,
    REPORT_BYTES = 8191,
    HEAD_BYTES = 16,
    BMP_BYTES = KEY_BMP_HEAD + 3 * SIDE * SIDE,
    PAGES = 2,
    PAGE_BYTES = BMP_BYTES / PAGES,
    PER_METRE = 3780, /* 96 dots per inch */
    FEATURE_BYTES = 17,
    INPUT = 1
};

typedef struct original {
    uint8_t shown[KEYS][BMP_BYTES];
    uint8_t next[BMP_BYTES];
    uint8_t known[KEYS]; /* what is `shown` is on the key */
    uint8_t report[REPORT_BYTES];
} original;

/* The device's number of the key that is the picture's `key`, and back. */
static unsigned from_right(unsigned key) {
    return key - key % COLUMNS + COLUMNS - 1 - key % COLUMNS;
}

static void key_image(const picture *p, unsigned key, uint8_t *to) {
    const unsigned left = key % COLUMNS * SIDE, top = key / COLUMNS * SIDE;
    key_bmp_head(to, SIDE, PER_METRE);
    to += KEY_BMP_HEAD;
    for (unsigned i = 0; i < SIDE * SIDE; i++, to += 3) {
        const unsigned x = left + SIDE - 1 - i % SIDE, y = top + i / SIDE;
        const uint8_t *rgb = p->rgb + 3 * ((size_t)y * p->width + x);
        to[0] = rgb[2];
        to[1] = rgb[1];
        to[2] = rgb[0];
    }
}

static int send_key(display *d, unsigned key) {
    original *o = d->state;
    for (unsigned page = 0; page < PAGES; page++) {
        const uint8_t head[HEAD_BYTES] = {
            2, 1, (uint8_t)(page + 1), 0, page + 1 == PAGES, (uint8_t)(from_right(key) + 1)};
        memset(o->report, 0, REPORT_BYTES);
        memcpy(o->report, head, HEAD_BYTES);
        memcpy(o->report + HEAD_BYTES, o->next + page * PAGE_BYTES, PAGE_BYTES);
        const int status = port_output(d->port, o->report, REPORT_BYTES);
        if (status != PORT_OK || display_is_stopped(d)) {
            return status != PORT_OK ? display_status(status) : DISPLAY_STOPPED;
        }
    }
    return DISPLAY_OK;
}

static int original_show(display *d, const picture *p, fail *f) {
    original *o = d->state;
    (void)f;
    for (unsigned key = 0; key < KEYS; key++) {
        key_image(p, key, o->next);
        if (o->known[key] && memcmp(o->shown[key], o->next, BMP_BYTES) == 0) {
            continue;
        }
        o->known[key] = 0;
        const int status = send_key(d, key);
        if (status != DISPLAY_OK) {
            return status;
        }
        memcpy(o->shown[key], o->next, BMP_BYTES);
        o->known[key] = 1;
    }
    return DISPLAY_OK;
}

static void take_report(display *d, const uint8_t *report, size_t bytes) {
    for (unsigned i = 0; bytes >= 1 + KEYS && report[0] == INPUT && i < DECK_KEYS_STEER; i++) {
        keys_set(&d->keys, i, report[1 + from_right(i % 4 + i / 4 * COLUMNS)] != 0);
    }
}

static int original_tick(display *d) {
    return display_hear(d, take_report);
}

static int original_brightness(display *d, unsigned percent, fail *f) {
    const uint8_t report[FEATURE_BYTES] = {0x05, 0x55, 0xAA, 0xD1, 0x01, (uint8_t)percent};
    (void)f;
    return display_status(port_feature(d->port, report, sizeof report));
}

static int original_release(display *d, fail *f) {
    const uint8_t report[FEATURE_BYTES] = {0x0B, 0x63};
    (void)f;
    return display_status(port_feature(d->port, report, sizeof report));
}

static void original_forget(display *d, unsigned key) {
    original *o = d->state;
    o->known[key] = 0;
}

static void original_close(display *d) {
    free(d->state);
    d->state = NULL;
}

static int original_open(display *d, fail *f) {
    d->width = COLUMNS * SIDE;
    d->height = ROWS * SIDE;
    d->pieces = KEYS;
    original *o = d->state = calloc(1, sizeof(original));
    if (o == NULL) {
        return fail_set(f, NULL, "out of memory; close other programs");
    }
    o->report[0] = 2;
    const int status = display_status(port_output(d->port, o->report, REPORT_BYTES));
    if (status != DISPLAY_OK) {
        original_close(d);
    }
    return status;
}

static const key_grid grid = {COLUMNS, ROWS, SIDE, 25, 25}; /* gaps: as the npm package has them */

static const driver_id ids[] = {{0x0FD9, 0x0060, 0}, {0, 0, 0}};

const driver driver_streamdeck_original = {.name = "streamdeck-original",
                                           .about =
                                               "Elgato Stream Deck (the first), 15 keys as 360x216",
                                           .ids = ids,
                                           .from_notes = 1,
                                           .open = original_open,
                                           .show = original_show,
                                           .forget = original_forget,
                                           .tick = original_tick,
                                           .keys = deck_keys_72,
                                           .grid = &grid,
                                           .brightness = original_brightness,
                                           .release = original_release,
                                           .close = original_close};
