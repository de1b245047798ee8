/* model_mini - an Elgato Stream Deck Mini: one BMP file per key, shown on its side
 *
 * The file is read as BMP says, bottom row first; what the key then shows is
 * that picture mirrored about its diagonal.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "tests/hid/model.h"

enum {
    SIDE = 80,
    KEYS = 6,
    FILE_BYTES = 54 + 3 * SIDE * SIDE,
    PAGE = 1008,
    PAGES = 20,
    QUEUE = 64
};

typedef struct mini {
    uint8_t file[PAGES * PAGE];
    unsigned next, key; /* page; key that is being sent */
    uint8_t down[KEYS], told[QUEUE][KEYS];
    unsigned waiting; /* of told */
} mini;

static int mini_open(model *m) {
    m->state = calloc(1, sizeof(mini));
    return m->state == NULL ? -1 : 0;
}

static uint32_t u32(const uint8_t *p) {
    return p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

static int is_bmp(const uint8_t *f) {
    return f[0] == 'B' && f[1] == 'M' && u32(f + 2) == FILE_BYTES && u32(f + 10) == 54 &&
           u32(f + 14) == 40 && u32(f + 18) == SIDE && u32(f + 22) == SIDE && f[26] == 1 &&
           f[28] == 24 && u32(f + 30) == 0 && u32(f + 34) == 3 * SIDE * SIDE;
}

static void show_key(model *m, const uint8_t *pixels, unsigned key) {
    const unsigned left = key % 3 * SIDE, top = key / 3 * SIDE;
    for (unsigned y = 0; y < SIDE; y++) {
        for (unsigned x = 0; x < SIDE; x++) {
            /* pixel (column y, row x) of the picture, which is stored upside down */
            const uint8_t *bgr = pixels + 3 * ((SIDE - 1 - x) * SIDE + y);
            uint8_t *rgb = m->rgb + 3 * ((top + y) * m->width + left + x);
            rgb[0] = bgr[2];
            rgb[1] = bgr[1];
            rgb[2] = bgr[0];
        }
    }
    m->changes++;
    if (m->changed != NULL) {
        m->changed(m->context, m);
    }
}

static int ends_image(const uint8_t *r, size_t bytes) {
    unsigned other = 0;
    for (size_t i = 1; i < bytes; i++) {
        other |= r[i];
    }
    return bytes == 1024 && r[0] == 2 && other == 0;
}

static void mini_output(model *m, const uint8_t *r, size_t bytes) {
    mini *d = m->state;
    if (ends_image(r, bytes)) {
        d->next = PAGES;
        return;
    }
    if (bytes != 1024 || r[0] != 2 || r[1] != 1 || r[3] != 0 || r[5] < 1 || r[5] > KEYS) {
        model_breach(m, "not an image report of 1024 bytes");
        return;
    }
    if (r[2] == 0 && d->next > 0 && d->next < PAGES) {
        model_breach(m, "an image begins and the one before was not ended");
    }
    if (r[2] == 0) {
        d->next = 0;
        d->key = r[5];
    }
    if (r[2] != d->next || r[5] != d->key || r[4] != (d->next == PAGES - 1)) {
        model_breach(m, "page out of order, or its key or last flag is wrong");
        return;
    }
    memcpy(d->file + PAGE * (size_t)d->next, r + 16, PAGE);
    if (d->next++ == PAGES - 1) {
        if (!is_bmp(d->file)) {
            model_breach(m, "not a BMP file of 80x80 pixels of 24 bits");
            return;
        }
        show_key(m, d->file + 54, d->key - 1u);
    }
}

static void mini_feature(model *m, const uint8_t *r, size_t bytes) {
    static const uint8_t brightness[] = {0x05, 0x55, 0xAA, 0xD1, 0x01};
    if (bytes == 17 && memcmp(r, brightness, 5) == 0 && r[5] <= 100) {
        m->brightness = r[5];
    } else if (bytes == 17 && r[0] == 0x0B && r[1] == 0x63) {
        m->releases++;
    } else {
        model_breach(m, "a feature report that is neither brightness nor reset");
    }
}

/* A report for every change, as many as the kernel keeps. */
static void mini_key(model *m, unsigned key, int is_down) {
    mini *d = m->state;
    if (key < KEYS && d->waiting < QUEUE) {
        d->down[key] = is_down != 0;
        memcpy(d->told[d->waiting++], d->down, KEYS);
    }
}

static size_t mini_input(model *m, uint8_t *report, size_t room) {
    mini *d = m->state;
    if (d->waiting == 0 || room < 17) {
        return 0;
    }
    memset(report, 0, 17);
    report[0] = 1;
    memcpy(report + 1, d->told[0], KEYS);
    memmove(d->told[0], d->told[1], --d->waiting * sizeof d->told[0]);
    return 17;
}

const model_kind model_mini = {.name = "streamdeck-mini",
                               .vendor = 0x0FD9,
                               .id = 0x0063,
                               .width = 3 * SIDE,
                               .height = 2 * SIDE,
                               .output_number = 2,
                               .feature_number = 5,
                               .input_number = 1,
                               .output_bytes = 1023,
                               .feature_bytes = 16,
                               .input_bytes = 16,
                               .open = mini_open,
                               .output = mini_output,
                               .input = mini_input,
                               .key = mini_key,
                               .feature = mini_feature};
