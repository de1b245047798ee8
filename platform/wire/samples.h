/* samples - a pixel as the numbers that the codec predicts
 *
 * The first is green or grey, which the others follow closely; then red and
 * blue. One-sample formats have no others.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_SAMPLES_H
#define PLT_WIRE_SAMPLES_H

#include "platform/wire/wire_format.h"

typedef struct wire_sample {
    uint8_t v[4]; /* the last is not used: four bytes are moved at once */
} wire_sample;

static inline int wire_has_colour(unsigned format) {
    return format <= WIRE_RGB888;
}

/* What a run counts: whole pixels, or bytes of several. */
static inline uint32_t wire_unit_bytes(unsigned format) {
    return format == WIRE_RGB565 ? 2 : format == WIRE_RGB888 ? 3 : 1;
}

/* Largest value of the first sample; of the others half of it for 565. */
static inline int wire_sample_most(unsigned format, unsigned which) {
    static const uint8_t most[WIRE_FORMATS][2] = {{63, 31}, {255, 255}, {255, 0}, {15, 0}, {1, 0}};
    return most[format][which > 0];
}

static inline wire_sample wire_sample_get(unsigned format, const uint8_t *row, unsigned x) {
    wire_sample s = {{0, 0, 0, 0}};
    switch (format) {
    case WIRE_RGB565:
        row += 2 * x;
        s.v[0] = (uint8_t)((row[0] & 7) << 3 | row[1] >> 5);
        s.v[1] = row[0] >> 3;
        s.v[2] = row[1] & 31;
        break;
    case WIRE_RGB888:
        row += 3 * x;
        s.v[0] = row[1], s.v[1] = row[0], s.v[2] = row[2];
        break;
    case WIRE_GREY8:
        s.v[0] = row[x];
        break;
    case WIRE_GREY4:
        s.v[0] = row[x / 2] >> (x & 1 ? 0 : 4) & 15;
        break;
    default:
        s.v[0] = row[x / 8] >> (7 - (x & 7)) & 1;
    }
    return s;
}

/* Pixels that share a byte are written from left to right. */
static inline void wire_sample_put(unsigned format, uint8_t *row, unsigned x, wire_sample s) {
    switch (format) {
    case WIRE_RGB565:
        row += 2 * x;
        row[0] = (uint8_t)(s.v[1] << 3 | s.v[0] >> 3);
        row[1] = (uint8_t)(s.v[0] << 5 | s.v[2]);
        break;
    case WIRE_RGB888:
        row += 3 * x;
        row[0] = s.v[1], row[1] = s.v[0], row[2] = s.v[2];
        break;
    case WIRE_GREY8:
        row[x] = s.v[0];
        break;
    case WIRE_GREY4:
        row[x / 2] = (uint8_t)(x & 1 ? row[x / 2] | s.v[0] : s.v[0] << 4);
        break;
    default:
        row[x / 8] = (uint8_t)((x & 7 ? row[x / 8] : 0) | s.v[0] << (7 - (x & 7)));
    }
}

/* `width` pixels of a row. The format of most panels has a loop of its own. */
static inline void wire_samples_get(unsigned format, const uint8_t *row, unsigned width,
                                    wire_sample *to) {
    for (unsigned x = 0; format == WIRE_RGB565 && x < width; x++) {
        to[x] = wire_sample_get(WIRE_RGB565, row, x);
    }
    for (unsigned x = 0; format != WIRE_RGB565 && x < width; x++) {
        to[x] = wire_sample_get(format, row, x);
    }
}

static inline void wire_samples_put(unsigned format, uint8_t *row, unsigned width,
                                    const wire_sample *from) {
    for (unsigned x = 0; format == WIRE_RGB565 && x < width; x++) {
        wire_sample_put(WIRE_RGB565, row, x, from[x]);
    }
    for (unsigned x = 0; format != WIRE_RGB565 && x < width; x++) {
        wire_sample_put(format, row, x, from[x]);
    }
}

#endif
