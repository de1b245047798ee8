/* driver_streamdeck_mini - Elgato Stream Deck Mini: six keys over one panel
 *
 * The keys are used as one picture of 240x160 without gaps, key 0 top left,
 * key 2 top right, key 5 bottom right. A key's image is a BMP file of 80x80
 * pixels of 24 bits, its panel lying on its side: the file's first row, read
 * in the order of its bytes, is the key's right column from top to bottom.
 * It goes in output reports of 1024 bytes:
 *
 *     0  02 01     report number, command
 *     2  page      0, 1, ...
 *     4  last      1 in the last report of a key, which then changes
 *     5  key + 1
 *     16 1008 bytes of the file, zeros after its end
 *
 * A report of 02 and zeros ends an image that another program did not send to
 * its end. Brightness and reset are feature reports of 17 bytes. Only keys that
 * changed since the last picture are sent. An input report comes when a key
 * is pressed or released: 01, then a byte per key, not 0 while it is down.
 *
 * A scene is turned by the lower row and the upper middle, as by arrow keys;
 * left and right of that are nearer and farther, and both together are the
 * first view again.
 *
 * Sources: Elgato, "Stream Deck Mini Protocol", docs.elgato.com, read 2026;
 * python-elgato-streamdeck (D. Camera), facts only. Not run on hardware.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "host_tools/hid/device/symbols.h"
#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/hid/drivers/key_bmp.h"

enum {
    KEY_SIDE = 80,
    COLUMNS = 3,
    KEYS = 6,
    REPORT_BYTES = 1024,
    HEAD_BYTES = 16,
    PAGE_BYTES = REPORT_BYTES - HEAD_BYTES,
    BMP_BYTES = KEY_BMP_HEAD + 3 * KEY_SIDE * KEY_SIDE,
    PER_METRE = 2835, /* 72 dots per inch */
    FEATURE_BYTES = 17,
    INPUT = 1,    /* number of the report */
    SYMBOL_X = 4, /* in a key's lower left corner */
    SYMBOL_Y = KEY_SIDE - SYMBOL_SIDE - 4
};

typedef struct mini {
    uint8_t shown[KEYS][BMP_BYTES];
    uint8_t next[BMP_BYTES];
    int known[KEYS]; /* shown[k] is on the key */
} mini;

static void key_image(const picture *p, unsigned key, uint8_t *to) {
    const unsigned left = key % COLUMNS * KEY_SIDE, top = key / COLUMNS * KEY_SIDE;
    key_bmp_head(to, KEY_SIDE, PER_METRE);
    to += KEY_BMP_HEAD;
    for (unsigned row = 0; row < KEY_SIDE; row++) {
        for (unsigned column = 0; column < KEY_SIDE; column++, to += 3) {
            const unsigned x = left + KEY_SIDE - 1 - row, y = top + column;
            const uint8_t *rgb = p->rgb + 3 * ((size_t)y * p->width + x);
            to[0] = rgb[2];
            to[1] = rgb[1];
            to[2] = rgb[0];
        }
    }
}

static int send_key(display *d, unsigned key, const uint8_t *image) {
    for (unsigned page = 0, at = 0; at < BMP_BYTES; page++, at += PAGE_BYTES) {
        const unsigned left = BMP_BYTES - at;
        uint8_t report[REPORT_BYTES] = {
            2, 1, (uint8_t)page, 0, left <= PAGE_BYTES, (uint8_t)(key + 1)};
        memcpy(report + HEAD_BYTES, image + at, left < PAGE_BYTES ? left : PAGE_BYTES);
        const int status = port_output(d->port, report, sizeof report);
        if (status != PORT_OK || display_is_stopped(d)) {
            return status != PORT_OK ? display_status(status) : DISPLAY_STOPPED;
        }
    }
    return DISPLAY_OK;
}

static int mini_show(display *d, const picture *p, fail *f) {
    mini *m = d->state;
    (void)f;
    for (unsigned key = 0; key < KEYS; key++) {
        key_image(p, key, m->next);
        if (m->known[key] && memcmp(m->shown[key], m->next, BMP_BYTES) == 0) {
            continue;
        }
        m->known[key] = 0;
        const int status = send_key(d, key, m->next);
        if (status != DISPLAY_OK) {
            return status;
        }
        memcpy(m->shown[key], m->next, BMP_BYTES);
        m->known[key] = 1;
    }
    return DISPLAY_OK;
}

/* A report of another number, or a short one, is no keys' report. */
static void take_report(display *d, const uint8_t *report, size_t bytes) {
    if (bytes >= 1 + KEYS && report[0] == INPUT) {
        for (unsigned key = 0; key < KEYS; key++) {
            keys_set(&d->keys, key, report[1 + key] != 0);
        }
    }
}

static int mini_tick(display *d) {
    return display_hear(d, take_report);
}

static int mini_brightness(display *d, unsigned percent, fail *f) {
    const uint8_t report[FEATURE_BYTES] = {0x05, 0x55, 0xAA, 0xD1, 0x01, (uint8_t)percent};
    (void)f;
    return display_status(port_feature(d->port, report, sizeof report));
}

static int mini_release(display *d, fail *f) {
    const uint8_t report[FEATURE_BYTES] = {0x0B, 0x63};
    (void)f;
    return display_status(port_feature(d->port, report, sizeof report));
}

static void mini_forget(display *d, unsigned key) {
    mini *m = d->state;
    m->known[key] = 0;
}

static void mini_close(display *d) {
    free(d->state);
    d->state = NULL;
}

static int mini_open(display *d, fail *f) {
    const uint8_t ends_image[REPORT_BYTES] = {2};
    d->width = COLUMNS * KEY_SIDE;
    d->height = KEYS / COLUMNS * KEY_SIDE;
    d->pieces = KEYS;
    d->state = calloc(1, sizeof(mini));
    if (d->state == NULL) {
        return fail_set(f, NULL, "out of memory; close other programs");
    }
    const int status = display_status(port_output(d->port, ends_image, sizeof ends_image));
    if (status != DISPLAY_OK) {
        mini_close(d);
    }
    return status;
}

#define AT(column, row) (column) * KEY_SIDE + SYMBOL_X, (row)*KEY_SIDE + SYMBOL_Y
static const display_key keys[] = {{"top left", STEER_NEARER, AT(0, 0)},
                                   {"top middle", STEER_UP, AT(1, 0)},
                                   {"top right", STEER_FARTHER, AT(2, 0)},
                                   {"bottom left", STEER_LEFT, AT(0, 1)},
                                   {"bottom middle", STEER_DOWN, AT(1, 1)},
                                   {"bottom right", STEER_RIGHT, AT(2, 1)},
                                   {NULL, STEER_LEFT, 0, 0}};

/* Gaps: as the npm package @elgato-stream-deck/core 7.6.3 has them. */
static const key_grid grid = {COLUMNS, KEYS / COLUMNS, KEY_SIDE, 28, 28};

static const driver_id ids[] = {
    {0x0FD9, 0x0063, 0}, {0x0FD9, 0x0090, 0}, {0x0FD9, 0x00B3, 0}, {0x0FD9, 0x00B8, 0}, {0, 0, 0}};

const driver driver_streamdeck_mini = {
    .name = "streamdeck-mini",
    .about = "Elgato Stream Deck Mini and 6-key module, six keys as 240x160",
    .ids = ids,
    .from_notes = 1,
    .open = mini_open,
    .show = mini_show,
    .forget = mini_forget,
    .tick = mini_tick,
    .keys = keys,
    .grid = &grid,
    .brightness = mini_brightness,
    .release = mini_release,
    .close = mini_close};
