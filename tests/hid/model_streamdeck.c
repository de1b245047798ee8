/* model_streamdeck - Elgato Stream Decks of 15 and 32 keys, Neo and +: JPEG files on keys
 *
 * A file is put together from its parts and read by tests/reference/jpeg_decode.h when the last has
 * come. What a key then shows is that picture, upside down on all but the +.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "tests/hid/model.h"
#include "tests/reference/jpeg_decode.h"

enum { ROOM = 200000, LOWER = 255 };

typedef struct deck {
    uint8_t file[ROOM];
    size_t bytes;
    unsigned part, key; /* due next; the key that is being sent, or LOWER */
} deck;

static int deck_open(model *m) {
    m->state = calloc(1, sizeof(deck));
    return m->state == NULL ? -1 : 0;
}

static unsigned u16(const uint8_t *p) {
    return p[0] | (unsigned)p[1] << 8;
}

static int has_strip(const model *m) {
    return m->kind->height == 300;
}

static int has_window(const model *m) {
    return m->kind->height == 237;
}

static unsigned side_of(const model *m) {
    return m->kind->width == 360 ? 72 : has_strip(m) ? 120 : 96;
}

static uint8_t byte_of(double value) {
    return (uint8_t)(value < 0 ? 0 : value > 255 ? 255 : value + 0.5);
}

static void rgb_at(const jpeg_decoded *d, unsigned x, unsigned y, uint8_t *rgb) {
    const double luma = jpeg_component(d, 0, x, y);
    const double blue = jpeg_component(d, 1, x, y) - 128, red = jpeg_component(d, 2, x, y) - 128;
    rgb[0] = byte_of(luma + 1.402 * red);
    rgb[1] = byte_of(luma - 0.344136 * blue - 0.714136 * red);
    rgb[2] = byte_of(luma + 1.772 * blue);
}

/* The strip's pixels in the middle of what a pixel of the picture covers: 5 for 3. */
static void show_strip(model *m, const jpeg_decoded *d) {
    for (unsigned y = 0; y < 60; y++) {
        for (unsigned x = 0; x < 480; x++) {
            rgb_at(d, (10 * x + 5) / 6, (10 * y + 5) / 6, m->rgb + 3 * ((240 + y) * 480 + x));
        }
    }
}

/* The window's pixels, which lie upside down, in the middle of what a pixel of the picture's middle
 * half covers. */
static void show_window(model *m, const jpeg_decoded *d) {
    memset(m->rgb + 3 * 192 * 384, 0, 3 * 45 * 384);
    for (unsigned y = 0; y < 45; y++) {
        for (unsigned x = 0; x < 192; x++) {
            rgb_at(d, 247 - (2 * x + 1) * 248 / 384, 57 - (2 * y + 1) * 58 / 90,
                   m->rgb + 3 * ((192 + y) * 384 + 96 + x));
        }
    }
}

static void show_key(model *m, const jpeg_decoded *d, unsigned key) {
    const unsigned side = side_of(m), columns = m->kind->width / side;
    for (unsigned y = 0; y < side; y++) {
        for (unsigned x = 0; x < side; x++) {
            const unsigned row = key / columns * side + (has_strip(m) ? y : side - 1 - y);
            const unsigned column = key % columns * side + (has_strip(m) ? x : side - 1 - x);
            rgb_at(d, x, y, m->rgb + 3 * ((size_t)row * m->kind->width + column));
        }
    }
}

static void show(model *m, const deck *k) {
    jpeg_decoded d = jpeg_decode(k->file, k->bytes);
    const int is_lower = k->key == LOWER;
    const unsigned width = !is_lower ? side_of(m) : has_strip(m) ? 800 : 248;
    const unsigned height = !is_lower ? side_of(m) : has_strip(m) ? 100 : 58;
    if (d.trouble != NULL || d.width != width || d.height != height) {
        model_breach(m, d.trouble != NULL ? d.trouble : "a JPEG file of another size");
    } else if (is_lower) {
        (has_strip(m) ? show_strip : show_window)(m, &d);
    } else {
        show_key(m, &d, k->key);
    }
    jpeg_decoded_free(&d);
    m->changes++;
    if (m->changed != NULL) {
        m->changed(m->context, m);
    }
}

static void take(model *m, unsigned key, unsigned part, unsigned last, const uint8_t *file,
                 unsigned bytes, unsigned room) {
    deck *k = m->state;
    if (part == 0) {
        k->part = 0;
        k->bytes = 0;
        k->key = key;
    }
    if (part != k->part || key != k->key || last > 1 || bytes < 1 || bytes > room ||
        (!last && bytes != room) || k->bytes + bytes > ROOM) {
        model_breach(m, "part out of order, or its key, size or last flag is wrong");
        return;
    }
    memcpy(k->file + k->bytes, file, bytes);
    k->bytes += bytes;
    k->part++;
    for (unsigned i = bytes; i < room; i++) {
        if (file[i] != 0) {
            model_breach(m, "something behind the file's end");
            return;
        }
    }
    if (last) {
        show(m, k);
    }
}

static void deck_output(model *m, const uint8_t *r, size_t bytes) {
    const unsigned side = side_of(m);
    const unsigned keys = m->kind->width / side * (m->kind->height / side);
    if (bytes == 1024 && r[0] == 2 && r[1] == 7 && r[2] < keys) {
        take(m, r[2], u16(r + 6), r[3], r + 8, u16(r + 4), 1016);
    } else if (bytes == 1024 && r[0] == 2 && r[1] == 0x0C && has_strip(m) && u16(r + 2) == 0 &&
               u16(r + 4) == 0 && u16(r + 6) == 800 && u16(r + 8) == 100 && r[15] == 0) {
        take(m, LOWER, u16(r + 11), r[10], r + 16, u16(r + 13), 1008);
    } else if (bytes == 1024 && r[0] == 2 && r[1] == 0x0B && has_window(m) && r[2] == 0) {
        take(m, LOWER, u16(r + 6), r[3], r + 8, u16(r + 4), 1016);
    } else {
        model_breach(m, "not a report of 1024 bytes for a key, or for what is below them");
    }
}

static void deck_feature(model *m, const uint8_t *r, size_t bytes) {
    if (bytes == 32 && r[0] == 3 && r[1] == 8 && r[2] <= 100) {
        m->brightness = r[2];
    } else if (bytes == 32 && r[0] == 3 && r[1] == 2) {
        m->releases++;
    } else {
        model_breach(m, "a feature report that is neither brightness nor reset");
    }
}

#define DECK(of, product, w, h)                                                                    \
    {                                                                                              \
        .name = of, .vendor = 0x0FD9, .id = product, .width = w, .height = h, .output_number = 2,  \
        .feature_number = 3, .input_number = 1, .output_bytes = 1023, .feature_bytes = 31,         \
        .input_bytes = 511, .lossy = 300, .open = deck_open, .output = deck_output,                \
        .feature = deck_feature                                                                    \
    }

const model_kind model_deck = DECK("streamdeck", 0x0080, 360, 216);
const model_kind model_deck_xl = DECK("streamdeck-xl", 0x008F, 768, 384);
const model_kind model_deck_neo = DECK("streamdeck-neo", 0x009A, 384, 237);
const model_kind model_deck_plus = DECK("streamdeck-plus", 0x0084, 480, 300);
