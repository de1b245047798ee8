/* tile_encode - pixels of a tile to the fewest bytes
 *
 * Every coder is tried; the predictive one gets no more room than the others
 * would need. Invariant: what is written decodes to `pixels`.
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "platform/wire/wire_tile.h"

uint32_t wire_tile_bytes(wire_tile_shape shape) {
    if (shape.width < 1 || shape.width > WIRE_TILE_SIDE || shape.height < 1 ||
        shape.height > WIRE_TILE_SIDE) {
        return 0;
    }
    return wire_row_bytes(shape.format, shape.width) * shape.height;
}

/* What a run counts: whole pixels, or bytes of several. */
static uint32_t unit_of(unsigned format) {
    return format == WIRE_RGB565 ? 2 : format == WIRE_RGB888 ? 3 : 1;
}

static uint32_t run_from(const uint8_t *units, uint32_t unit, uint32_t count, uint32_t most) {
    uint32_t n = 1;
    while (n < count && n < most && memcmp(units, units + n * unit, unit) == 0) {
        n++;
    }
    return n;
}

/* Units before the next run of at least two. */
static uint32_t literals_from(const uint8_t *units, uint32_t unit, uint32_t count) {
    uint32_t n = 0;
    while (n < count && n < 128 && run_from(units + n * unit, unit, count - n, 2) == 1) {
        n++;
    }
    return n;
}

/* Bytes of the run coding; written when `to` is not NULL. */
static uint32_t encode_runs(const uint8_t *units, uint32_t unit, uint32_t count, uint8_t *to) {
    uint32_t used = 0;
    while (count > 0) {
        const uint32_t run = run_from(units, unit, count, 129);
        const uint32_t n = run > 1 ? run : literals_from(units, unit, count);
        const uint32_t bytes = (run > 1 ? 1 : n) * unit;
        if (to != NULL) {
            to[used] = (uint8_t)(run > 1 ? n + 126 : n - 1);
            memcpy(to + used + 1, units, bytes);
        }
        used += 1 + bytes;
        units += n * unit;
        count -= n;
    }
    return used;
}

/* A pixel's bits into the coder. */
static void encode_pixel(wire_model *m, wire_range_out *c, wire_sample pixel) {
    int done;
    wire_model_pixel(m);
    do {
        const unsigned bit = wire_model_wish(m, pixel);
        uint16_t *chance = wire_model_chance(m);
        if (chance == NULL) {
            wire_range_put(c, c->range >> 1, bit);
        } else {
            wire_range_put(c, (c->range >> 12) * (*chance >> 4), bit);
            wire_chance_learn(chance, bit);
        }
        done = wire_model_bit(m, bit);
    } while (done == 0);
}

/* Bytes, or 0 when it takes more than `room`. */
static uint32_t encode_predicted(wire_tile_shape shape, const uint8_t *pixels, const uint8_t *old,
                                 unsigned near, uint8_t *to, uint32_t room) {
    const uint32_t row_bytes = wire_row_bytes(shape.format, shape.width);
    wire_range_out c = {to + 1, 0, room - 1, 0, UINT32_MAX};
    wire_model m;
    to[0] = (uint8_t)(near | (old != NULL ? MODEL_DELTA : 0));
    wire_model_start(&m, shape, to[0]);
    for (unsigned y = 0; y < shape.height && c.used <= c.room; y++) {
        for (unsigned x = 0; x < shape.width; x++) {
            if (old != NULL) {
                m.old = wire_sample_get(shape.format, old + y * row_bytes, x);
            }
            encode_pixel(&m, &c, wire_sample_get(shape.format, pixels + y * row_bytes, x));
        }
    }
    wire_range_end(&c);
    return c.used <= c.room ? c.used + 1 : 0;
}

/* What the decoder will make of it. */
static void take_back(wire_tile_shape shape, uint8_t *pixels, const uint8_t *old,
                      const uint8_t *coded, uint32_t bytes) {
    const uint32_t row_bytes = wire_row_bytes(shape.format, shape.width);
    wire_tile_reader reader;
    const uint8_t *at = coded;
    wire_tile_begin(&reader, shape, WIRE_PREDICT, bytes, old, row_bytes);
    while (wire_tile_read(&reader, &at, coded + bytes) == WIRE_TILE_ROW) {
        wire_tile_row(&reader, pixels + (reader.y - 1u) * row_bytes);
    }
}

uint32_t wire_tile_encode(wire_tile_shape shape, uint8_t *pixels, const uint8_t *old, unsigned near,
                          uint8_t *to, uint32_t room, unsigned *coder) {
    const uint32_t raw = wire_tile_bytes(shape), unit = unit_of(shape.format);
    const uint32_t runs = encode_runs(pixels, unit, raw / unit, NULL);
    uint32_t best = runs < raw ? runs : raw;
    near = shape.format >= WIRE_GREY4 ? 0 : near;
    if (runs <= 1 + unit || run_from(pixels, unit, raw / unit, raw) == raw / unit) {
        *coder = WIRE_SOLID;
        best = unit;
        memcpy(to, pixels, best <= room ? best : 0);
        return best <= room ? best : 0;
    }
    const uint32_t least = best - 1 < room ? best - 1 : room;
    const uint32_t bytes = least > 1 ? encode_predicted(shape, pixels, old, near, to, least) : 0;
    if (bytes > 0) {
        *coder = WIRE_PREDICT;
        if (near > 0) {
            take_back(shape, pixels, old, to, bytes);
        }
        return bytes;
    }
    if (best > room) {
        return 0;
    }
    *coder = runs < raw ? WIRE_RUNS : WIRE_RAW;
    if (*coder == WIRE_RUNS) {
        encode_runs(pixels, unit, raw / unit, to);
    } else {
        memcpy(to, pixels, raw);
    }
    return best;
}
