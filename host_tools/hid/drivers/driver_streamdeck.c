/* driver_streamdeck - Elgato Stream Decks whose keys take JPEG files: 15 and 32 keys, Neo, +
 *
 * The keys are used as one picture without gaps, key 0 top left, row by row. A key's image is a
 * JPEG file, which lies upside down (both ways turned) but on a Stream Deck +. It goes in output
 * reports of 1024 bytes:
 *
 *     0  02 07     report number, command
 *     2  key       from 0
 *     3  last      1 in the last report of a key, which then changes
 *     4  bytes     of the file in this report, little-endian
 *     6  part      0, 1, ..., little-endian
 *     8 1016 bytes of the file, zeros after its end
 *
 * A Stream Deck + has a strip of 800x100 below its keys. It shows the 60 rows of the picture there,
 * which are as wide as the keys and so 5/3 times as large, in reports that begin
 *
 *     0  02 0C     2  x, y, width, height     10  last     11  part     13  bytes     16 the file
 *
 * A Neo has a window of 248x58 below its middle keys. It shows what is there of the 45 rows of the
 * picture below the keys, 192 columns, in reports like a key's, with 02 0B 00 for 02 07 and the
 * key, and upside down as keys are.
 *
 * A file has the best quality, 95 at most, with which it takes 1.5 bytes per pixel, 8 reports for a
 * key of 72x72: with a chroma sample per pixel if that leaves a quality of 85, else with one for
 * 2x2 pixels. Only keys that changed since the last picture are sent. Brightness and the device's
 * own picture are feature reports of 32 bytes. An input report comes when a key, or a dial of a +,
 * is used:
 *
 *     0  01 00     2  bytes     4  a byte per key, 1: it is down
 *     0  01 03     2  bytes     4  0     5  a byte per dial, 1: it is pressed
 *     0  01 03     2  bytes     4  1     5  a byte per dial: how far it was turned, signed
 *     0  01 02     2  bytes     4  1 touch, 2 hold, 3 swipe     6  x, y     10  x, y at its end
 *
 * A scene is turned by the first two rows as on a Mini, beside them is the first view again, and
 * what stops a sequence; by dials: left and right, down and up, and nearer and farther; on the
 * strip it goes with the finger.
 *
 * Sources: Elgato, "Main Protocol: General Reference", docs.elgato.com, read 2026; the npm package
 * @elgato-stream-deck/core 7.6.3 (J. Waller), facts only. Not run on hardware.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "host_tools/hid/drivers/deck_keys.h"
#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/picture/jpeg.h"

enum {
    REPORT_BYTES = 1024,
    KEY_HEAD = 8,
    STRIP_HEAD = 16,
    FEATURE_BYTES = 32,
    DECK_KEYS_MOST = 32,
    INPUT = 1, /* report number */
    OF_KEYS = 0,
    OF_STRIP = 2,
    OF_DIALS = 3,
    TOUCH = 1,
    HOLD = 2,
    SWIPE = 3,
    STRIP_INPUT_BYTES = 14,
    SWIPE_STEP = 50, /* pixels of the strip */
    FULL_CHROMA_LEAST = 85,
    QUALITY_MOST = 95
};

/* A second panel below the keys, and the part of the picture that it shows. */
typedef struct lower_panel {
    uint8_t command;              /* 0: there is none */
    unsigned left, columns, rows; /* of the picture, from the last row of keys on */
    unsigned width, height;       /* its own pixels */
} lower_panel;

typedef struct layout {
    unsigned columns, rows, side;
    int turned; /* all lies upside down */
    lower_panel lower;
} layout;

enum { COMMAND_KEY = 0x07, COMMAND_WINDOW = 0x0B, COMMAND_STRIP = 0x0C };

typedef struct deck {
    layout of;
    picture shown;                     /* of the whole panel */
    uint8_t known[DECK_KEYS_MOST + 1]; /* what is `shown` is on the key, or, behind the last, on
                                        * the lower panel */
    picture key, lower;                /* as they are sent */
    uint8_t *file;
    size_t room;
} deck;

/* ---- pictures of keys and strip --------------------------------------------------------- */

static const uint8_t *pixel(const picture *p, unsigned x, unsigned y) {
    return p->rgb + 3 * ((size_t)y * p->width + x);
}

/* The part of the panel that a key is: its first column and row. */
static void key_place(const layout *of, unsigned key, unsigned *left, unsigned *top) {
    *left = key % of->columns * of->side;
    *top = key / of->columns * of->side;
}

static int is_same(const picture *a, const picture *b, unsigned left, unsigned top, unsigned width,
                   unsigned height) {
    for (unsigned y = top; y < top + height; y++) {
        if (memcmp(pixel(a, left, y), pixel(b, left, y), (size_t)3 * width) != 0) {
            return 0;
        }
    }
    return 1;
}

static void key_image(const picture *panel, const layout *of, unsigned key, picture *to) {
    unsigned left, top;
    key_place(of, key, &left, &top);
    for (unsigned y = 0; y < of->side; y++) {
        for (unsigned x = 0; x < of->side; x++) {
            const unsigned column = of->turned ? of->side - 1 - x : x;
            const unsigned row = of->turned ? of->side - 1 - y : y;
            memcpy(to->rgb + 3 * (y * of->side + x), pixel(panel, left + column, top + row), 3);
        }
    }
}

/* Each pixel is the nearest one of the picture. */
static void lower_image(const picture *panel, const layout *of, picture *to) {
    const lower_panel *l = &of->lower;
    const unsigned top = of->rows * of->side;
    for (unsigned y = 0; y < l->height; y++) {
        for (unsigned x = 0; x < l->width; x++) {
            const unsigned column = of->turned ? l->width - 1 - x : x;
            const unsigned row = of->turned ? l->height - 1 - y : y;
            memcpy(to->rgb + 3 * (y * l->width + x),
                   pixel(panel, l->left + (2 * column + 1) * l->columns / (2 * l->width),
                         top + (2 * row + 1) * l->rows / (2 * l->height)),
                   3);
        }
    }
}

/* ---- files ------------------------------------------------------------------------------ */

/* Its size; the file is of the quality that the room allows. That of the lowest has room
 * (driver_corsair_lcd.c); 0: no file fits, and none is sent. */
static size_t jpeg_of(deck *k, const picture *p) {
    const size_t budget = (size_t)p->width * p->height * 3 / 2;
    const size_t room = budget < k->room ? budget : k->room;
    unsigned quality;
    size_t bytes = jpeg_fit(p, JPEG_444, FULL_CHROMA_LEAST, QUALITY_MOST, &quality, k->file, room);
    if (bytes > room) {
        bytes = jpeg_fit(p, JPEG_420, JPEG_QUALITY_LEAST, QUALITY_MOST, &quality, k->file, room);
    }
    return bytes <= room ? bytes : 0;
}

static void put_u16(uint8_t *to, size_t value) {
    to[0] = (uint8_t)value;
    to[1] = (uint8_t)(value >> 8);
}

/* The file in as many reports as it takes; `head` of them says how they begin, and where in them
 * last, bytes and part are. */
static int send_file(display *d, const uint8_t *head, size_t head_bytes, size_t bytes) {
    const deck *k = d->state;
    const size_t most = REPORT_BYTES - head_bytes;
    const int is_key = head_bytes == KEY_HEAD;
    for (size_t part = 0, at = 0; at < bytes; part++, at += most) {
        const size_t now = bytes - at < most ? bytes - at : most;
        uint8_t report[REPORT_BYTES] = {0};
        memcpy(report, head, head_bytes);
        report[is_key ? 3 : 10] = at + now == bytes;
        put_u16(report + (is_key ? 4 : 13), now);
        put_u16(report + (is_key ? 6 : 11), part);
        memcpy(report + head_bytes, k->file + at, now);
        const int status = port_output(d->port, report, sizeof report);
        if (status != PORT_OK || display_is_stopped(d)) {
            return status != PORT_OK ? display_status(status) : DISPLAY_STOPPED;
        }
    }
    return DISPLAY_OK;
}

static int send_key(display *d, const picture *p, unsigned key) {
    deck *k = d->state;
    const uint8_t head[KEY_HEAD] = {2, COMMAND_KEY, (uint8_t)key};
    key_image(p, &k->of, key, &k->key);
    return send_file(d, head, sizeof head, jpeg_of(k, &k->key));
}

static int send_lower(display *d, const picture *p) {
    deck *k = d->state;
    const lower_panel *l = &k->of.lower;
    uint8_t head[STRIP_HEAD] = {2, l->command};
    put_u16(head + 6, l->width);
    put_u16(head + 8, l->height);
    lower_image(p, &k->of, &k->lower);
    return send_file(d, head, l->command == COMMAND_STRIP ? STRIP_HEAD : KEY_HEAD,
                     jpeg_of(k, &k->lower));
}

/* Sends key `key`, or what lies behind the last one, the lower panel, if it changed. */
static int renew(display *d, const picture *p, unsigned key) {
    deck *k = d->state;
    const layout *of = &k->of;
    const int is_lower = key == of->columns * of->rows;
    unsigned left = of->lower.left, top = of->rows * of->side;
    if (!is_lower) {
        key_place(of, key, &left, &top);
    }
    const unsigned width = is_lower ? of->lower.columns : of->side;
    const unsigned height = is_lower ? of->lower.rows : of->side;
    if (k->known[key] && is_same(p, &k->shown, left, top, width, height)) {
        return DISPLAY_OK;
    }
    k->known[key] = 0;
    const int status = is_lower ? send_lower(d, p) : send_key(d, p, key);
    if (status == DISPLAY_OK) {
        for (unsigned y = top; y < top + height; y++) {
            memcpy(k->shown.rgb + 3 * ((size_t)y * p->width + left), pixel(p, left, y),
                   (size_t)3 * width);
        }
        k->known[key] = 1;
    }
    return status;
}

/* ---- the driver ------------------------------------------------------------------------- */

static int deck_show(display *d, const picture *p, fail *f) {
    (void)f;
    for (unsigned key = 0; key < d->pieces; key++) {
        const int status = renew(d, p, key);
        if (status != DISPLAY_OK) {
            return status;
        }
    }
    return DISPLAY_OK;
}

static void deck_forget(display *d, unsigned key) {
    deck *k = d->state;
    k->known[key] = 0;
}

static int deck_brightness(display *d, unsigned percent, fail *f) {
    const uint8_t report[FEATURE_BYTES] = {3, 8, (uint8_t)percent};
    (void)f;
    return display_status(port_feature(d->port, report, sizeof report));
}

static int deck_release(display *d, fail *f) {
    const uint8_t report[FEATURE_BYTES] = {3, 2};
    (void)f;
    return display_status(port_feature(d->port, report, sizeof report));
}

/* In the order of deck_keys.h. */
static void take_keys(display *d, const uint8_t *down, size_t count) {
    const unsigned columns = ((const deck *)d->state)->of.columns;
    for (unsigned i = 0; i < DECK_KEYS_STEER; i++) {
        const unsigned key = i % 4 + i / 4 * columns;
        if (key < count) {
            keys_set(&d->keys, i, down[key] != 0);
        }
    }
}

/* The first of two entries is for what goes to the left. */
static void take_steps(display *d, unsigned entry, int steps) {
    keys_step(&d->keys, entry + (steps > 0), (unsigned)(steps < 0 ? -steps : steps));
}

static void take_turns(display *d, const uint8_t *turned) {
    for (unsigned dial = 0; dial < DECK_DIALS_STEER; dial++) {
        take_steps(d, DECK_KEYS_STEER + 2 * dial, (int8_t)turned[dial]);
    }
}

static int get_u16(const uint8_t *from) {
    return from[0] | from[1] << 8;
}

static void take_touch(display *d, const uint8_t *report) {
    if (report[4] == SWIPE) {
        take_steps(d, DECK_SWIPE, (get_u16(report + 10) - get_u16(report + 6)) / SWIPE_STEP);
    } else if (report[4] == TOUCH || report[4] == HOLD) {
        keys_step(&d->keys, report[4] == TOUCH ? DECK_TOUCH : DECK_HOLD, 1);
    }
}

static void take_report(display *d, const uint8_t *report, size_t bytes) {
    const deck *k = d->state;
    if (bytes < 5 + DECK_DIALS_STEER || report[0] != INPUT) {
        return;
    }
    const size_t said = report[2] | (size_t)report[3] << 8;
    const size_t count = said < bytes - 4 ? said : bytes - 4;
    const int has_strip = k->of.lower.command == COMMAND_STRIP; /* and dials */
    if (report[1] == OF_KEYS) {
        take_keys(d, report + 4, count);
    } else if (report[1] == OF_DIALS && has_strip && report[4] == 1 && count > DECK_DIALS_STEER) {
        take_turns(d, report + 5);
    } else if (report[1] == OF_STRIP && has_strip && bytes >= STRIP_INPUT_BYTES) {
        take_touch(d, report);
    }
}

static int deck_tick(display *d) {
    return display_hear(d, take_report);
}

static void deck_close(display *d) {
    deck *k = d->state;
    picture_free(&k->shown);
    picture_free(&k->key);
    picture_free(&k->lower);
    free(k->file);
    free(k);
    d->state = NULL;
}

static int make_pictures(display *d, fail *f) {
    deck *k = d->state;
    const lower_panel *l = &k->of.lower;
    return picture_make(&k->shown, d->width, d->height, f) != 0 ||
                   picture_make(&k->key, k->of.side, k->of.side, f) != 0 ||
                   (l->command != 0 && picture_make(&k->lower, l->width, l->height, f) != 0)
               ? DISPLAY_FAILED
               : DISPLAY_OK;
}

static int open_as(display *d, layout of, fail *f) {
    const unsigned key = of.side * of.side, lower = of.lower.width * of.lower.height;
    deck *k = calloc(1, sizeof *k);
    if (k == NULL) {
        return fail_set(f, NULL, "out of memory; close other programs");
    }
    d->state = k;
    d->width = of.columns * of.side;
    d->height = of.rows * of.side + of.lower.rows;
    d->pieces = of.columns * of.rows + (of.lower.command != 0);
    k->of = of;
    k->room = (size_t)3 * (key > lower ? key : lower) / 2;
    k->file = malloc(k->room);
    if (k->file == NULL) {
        fail_set(f, NULL, "out of memory; close other programs");
    }
    if (k->file == NULL || make_pictures(d, f) != DISPLAY_OK) {
        deck_close(d);
        return DISPLAY_FAILED;
    }
    return DISPLAY_OK;
}

static int open_15(display *d, fail *f) {
    return open_as(d, (layout){.columns = 5, .rows = 3, .side = 72, .turned = 1}, f);
}

static int open_32(display *d, fail *f) {
    return open_as(d, (layout){.columns = 8, .rows = 4, .side = 96, .turned = 1}, f);
}

static int open_neo(display *d, fail *f) {
    const lower_panel window = {COMMAND_WINDOW, 96, 192, 45, 248, 58};
    return open_as(d, (layout){.columns = 4, .rows = 2, .side = 96, .turned = 1, .lower = window},
                   f);
}

static int open_plus(display *d, fail *f) {
    const lower_panel strip = {COMMAND_STRIP, 0, 480, 60, 800, 100};
    return open_as(d, (layout){.columns = 4, .rows = 2, .side = 120, .lower = strip}, f);
}

/* Gaps in pixels are those that the npm package has for the models. */
static const key_grid grid_15 = {5, 3, 72, 25, 25}, grid_32 = {8, 4, 96, 32, 39},
                      grid_neo = {4, 2, 96, 30, 30}, grid_plus = {4, 2, 120, 99, 40};

static const driver_id ids_15[] = {
    {0x0FD9, 0x006D, 0}, {0x0FD9, 0x0080, 0}, {0x0FD9, 0x00A5, 0}, {0x0FD9, 0x00B9, 0}, {0, 0, 0}};
static const driver_id ids_32[] = {
    {0x0FD9, 0x006C, 0}, {0x0FD9, 0x008F, 0}, {0x0FD9, 0x00BA, 0}, {0, 0, 0}};
static const driver_id ids_neo[] = {{0x0FD9, 0x009A, 0}, {0, 0, 0}};
static const driver_id ids_plus[] = {{0x0FD9, 0x0084, 0}, {0, 0, 0}};

#define DECK(of_name, of_about, of_ids, of_open, of_keys, of_grid)                                 \
    {                                                                                              \
        .name = of_name, .about = of_about, .ids = of_ids, .from_notes = 1, .open = of_open,       \
        .show = deck_show, .forget = deck_forget, .tick = deck_tick, .keys = of_keys,              \
        .grid = &of_grid, .brightness = deck_brightness, .release = deck_release,                  \
        .close = deck_close                                                                        \
    }

const driver driver_streamdeck =
    DECK("streamdeck", "Elgato Stream Deck V2, MK.2 and 15-key module, 15 keys as 360x216", ids_15,
         open_15, deck_keys_72, grid_15);
const driver driver_streamdeck_xl =
    DECK("streamdeck-xl", "Elgato Stream Deck XL and 32-key module, 32 keys as 768x384", ids_32,
         open_32, deck_keys_96, grid_32);
const driver driver_streamdeck_neo =
    DECK("streamdeck-neo", "Elgato Stream Deck Neo, eight keys and the window as 384x237", ids_neo,
         open_neo, deck_keys_96, grid_neo);
const driver driver_streamdeck_plus =
    DECK("streamdeck-plus", "Elgato Stream Deck +, eight keys and the strip as 480x300", ids_plus,
         open_plus, deck_keys_120, grid_plus);
