/* model_original - Elgato's first Stream Deck: BMP files in two halves
 *
 * The file is read as BMP says, bottom row first; what a key then shows is that picture turned
 * upside down both ways. The device counts keys from the right.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "tests/hid/model.h"

enum { SIDE = 72, FILE_BYTES = 54 + 3 * SIDE * SIDE, HALF = FILE_BYTES / 2 };

typedef struct original {
    uint8_t file[FILE_BYTES];
    unsigned key; /* of the first half; 0: there is none */
} original;

static int original_open(model *m) {
    m->state = calloc(1, sizeof(original));
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

static void show_key(model *m, const uint8_t *file, unsigned key) {
    const unsigned left = (4 - key % 5) * SIDE, top = key / 5 * SIDE;
    for (unsigned y = 0; y < SIDE; y++) {
        for (unsigned x = 0; x < SIDE; x++) {
            /* in the file row 0 is the picture's lowest */
            const uint8_t *bgr = file + 54 + 3 * ((SIDE - 1 - y) * SIDE + x);
            uint8_t *rgb =
                m->rgb + 3 * ((size_t)(top + SIDE - 1 - y) * m->width + left + SIDE - 1 - x);
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

static void original_output(model *m, const uint8_t *r, size_t bytes) {
    original *o = m->state;
    if (bytes == 8191 && r[0] == 2 && r[1] == 0) { /* ends what has begun */
        o->key = 0;
        return;
    }
    if (bytes != 8191 || r[0] != 2 || r[1] != 1 || r[2] < 1 || r[2] > 2 || r[3] != 0 ||
        r[4] != (r[2] == 2) || r[5] < 1 || r[5] > 15 || (r[2] == 2 && r[5] != o->key)) {
        model_breach(m, "not half of a key's image in 8191 bytes, or out of order");
        return;
    }
    memcpy(o->file + (r[2] - 1) * HALF, r + 16, HALF);
    o->key = r[2] == 1 ? r[5] : 0;
    if (r[2] == 2 && !is_bmp(o->file)) {
        model_breach(m, "not a BMP file of 72x72 pixels of 24 bits");
    } else if (r[2] == 2) {
        show_key(m, o->file, r[5] - 1u);
    }
}

static void original_feature(model *m, const uint8_t *r, size_t bytes) {
    static const uint8_t brightness[] = {0x05, 0x55, 0xAA, 0xD1, 0x01};
    if (bytes == 17 && memcmp(r, brightness, 5) == 0 && r[5] <= 100) {
        m->brightness = r[5];
    } else if (bytes == 17 && r[0] == 0x0B && r[1] == 0x63) {
        m->releases++;
    } else {
        model_breach(m, "a feature report that is neither brightness nor reset");
    }
}

const model_kind model_original = {.name = "streamdeck-original",
                                   .vendor = 0x0FD9,
                                   .id = 0x0060,
                                   .width = 5 * SIDE,
                                   .height = 3 * SIDE,
                                   .output_number = 2,
                                   .feature_number = 5,
                                   .input_number = 1,
                                   .output_bytes = 8190,
                                   .feature_bytes = 16,
                                   .input_bytes = 16,
                                   .open = original_open,
                                   .output = original_output,
                                   .feature = original_feature};
