/* model_corsair_lcd - a Corsair LCD: a JPEG file in parts, shown when the last has come
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "tests/hid/model.h"
#include "tests/reference/jpeg_decode.h"

enum { SIDE = 480, ROOM = 400 * 1016 };

typedef struct corsair {
    uint8_t file[ROOM];
    size_t bytes;
    unsigned part; /* due next */
} corsair;

static int corsair_open(model *m) {
    m->state = calloc(1, sizeof(corsair));
    return m->state == NULL ? -1 : 0;
}

static uint8_t byte_of(double value) {
    return (uint8_t)(value < 0 ? 0 : value > 255 ? 255 : value + 0.5);
}

static void show(model *m, const corsair *c) {
    jpeg_decoded d = jpeg_decode(c->file, c->bytes);
    const int is_good = d.trouble == NULL && d.width == SIDE && d.height == SIDE;
    if (!is_good) {
        model_breach(m, d.trouble != NULL ? d.trouble : "a JPEG file of another size");
    }
    for (unsigned i = 0; is_good && i < SIDE * SIDE; i++) {
        const double luma = jpeg_component(&d, 0, i % SIDE, i / SIDE);
        const double blue = jpeg_component(&d, 1, i % SIDE, i / SIDE) - 128;
        const double red = jpeg_component(&d, 2, i % SIDE, i / SIDE) - 128;
        m->rgb[3 * i] = byte_of(luma + 1.402 * red);
        m->rgb[3 * i + 1] = byte_of(luma - 0.344136 * blue - 0.714136 * red);
        m->rgb[3 * i + 2] = byte_of(luma + 1.772 * blue);
    }
    jpeg_decoded_free(&d);
    m->changes++;
    if (m->changed != NULL) {
        m->changed(m->context, m);
    }
}

static void corsair_output(model *m, const uint8_t *r, size_t bytes) {
    corsair *c = m->state;
    const unsigned part = r[4] | (unsigned)r[5] << 8, length = r[6] | (unsigned)r[7] << 8;
    if (bytes != 1024 || r[0] != 2 || r[1] != 5 || r[2] != 0x40) {
        model_breach(m, "not an image report of 1024 bytes");
        return;
    }
    if (part == 0) {
        c->part = 0;
        c->bytes = 0;
    }
    if (part != c->part || r[3] > 1 || length < 1 || length > 1016 || (!r[3] && length != 1016) ||
        c->bytes + length > ROOM) {
        model_breach(m, "part out of order, or its length or last flag is wrong");
        return;
    }
    memcpy(c->file + c->bytes, r + 8, length);
    c->bytes += length;
    c->part++;
    for (unsigned i = length; i < 1016; i++) {
        if (r[8 + i] != 0) {
            model_breach(m, "something behind the file's end");
            return;
        }
    }
    if (r[3]) {
        show(m, c);
    }
}

const model_kind model_corsair_lcd = {.name = "corsair-lcd",
                                      .vendor = 0x1B1C,
                                      .id = 0x0C39,
                                      .width = SIDE,
                                      .height = SIDE,
                                      .lossy = 4000,
                                      .output_number = 2,
                                      .input_number = 1,
                                      .output_bytes = 1023,
                                      .input_bytes = 511,
                                      .open = corsair_open,
                                      .output = corsair_output};
