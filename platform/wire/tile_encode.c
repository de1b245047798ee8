/* tile_encode - pixels of a tile to the fewest bytes
 *
 * Every coder is tried; one that needs more than another is given up.
 * Invariant: what is written decodes to `pixels` as they are afterwards.
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "platform/wire/model_code.h"
#include "platform/wire/wire_tile.h"

uint32_t wire_tile_bytes(wire_tile_shape shape) {
    if (shape.width < 1 || shape.width > WIRE_TILE_SIDE || shape.height < 1 ||
        shape.height > WIRE_TILE_SIDE) {
        return 0;
    }
    return wire_row_bytes(shape.format, shape.width) * shape.height;
}

static uint32_t run_from(const uint8_t *units, uint32_t unit, uint32_t count, uint32_t most) {
    uint32_t bytes = unit;
    most = (count < most ? count : most) * unit;
    while (bytes < most && units[bytes] == units[bytes - unit]) {
        bytes++;
    }
    return bytes / unit;
}

/* Units before the next run of at least two. */
static uint32_t literals_from(const uint8_t *units, uint32_t unit, uint32_t count) {
    uint32_t n = 0;
    while (n < count && n < 128 && run_from(units + n * unit, unit, count - n, 2) == 1) {
        n++;
    }
    return n;
}

/* Bytes of the run coding, written when `to` is not NULL; or some number
 * beyond `most` when it needs more. */
static uint32_t encode_runs(const uint8_t *units, uint32_t unit, uint32_t count, uint8_t *to,
                            uint32_t most) {
    uint32_t used = 0;
    while (count > 0 && used <= most) {
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

/* Bytes, or 0 when it needs more than `room`. `pixels` become what the decoder
 * gets, as far as they were coded. */
static uint32_t encode_predicted(wire_tile_shape shape, uint8_t *pixels, const uint8_t *old,
                                 unsigned near, uint8_t *to, uint32_t room) {
    const uint32_t row_bytes = wire_row_bytes(shape.format, shape.width);
    wire_range c = {to + 1, UINT32_MAX, 0, 0, room - 1, UINT32_MAX};
    wire_sample row[WIRE_TILE_SIDE], there[WIRE_TILE_SIDE];
    wire_model m;
    to[0] = (uint8_t)(near | (old != NULL ? MODEL_DELTA : 0));
    wire_model_start(&m, shape, to[0]);
    for (unsigned y = 0; y < shape.height && c.used <= c.room; y++) {
        wire_samples_get(shape.format, pixels + y * row_bytes, shape.width, row);
        if (old != NULL) {
            wire_samples_get(shape.format, old + y * row_bytes, shape.width, there);
        }
        for (unsigned x = 0; x < shape.width; x++) {
            wire_code_pixel(&m, &c, WIRE_ENCODES, there + x, row + x);
        }
        if (near > 0) {
            wire_samples_put(shape.format, pixels + y * row_bytes, shape.width, row);
        }
    }
    wire_range_end(&c);
    return c.used <= c.room ? c.used + 1 : 0;
}

static uint32_t encode_raw(const uint8_t *pixels, uint32_t bytes, uint8_t *to, uint32_t room) {
    memcpy(to, pixels, bytes <= room ? bytes : 0);
    return bytes <= room ? bytes : 0;
}

uint32_t wire_tile_encode(wire_tile_shape shape, uint8_t *pixels, const uint8_t *old, unsigned near,
                          uint8_t *to, uint32_t room, unsigned *coder) {
    const uint32_t raw = wire_tile_bytes(shape), unit = wire_unit_bytes(shape.format),
                   units = raw / unit;
    if (run_from(pixels, unit, units, units) == units) {
        *coder = WIRE_SOLID;
        return encode_raw(pixels, unit, to, room);
    }
    near = shape.format >= WIRE_GREY4 ? 0 : near;
    const uint32_t least = raw - 1 < room ? raw - 1 : room;
    const uint32_t bytes = least > 1 ? encode_predicted(shape, pixels, old, near, to, least) : 0;
    const uint32_t best = bytes > 0 ? bytes : least + 1;
    if (encode_runs(pixels, unit, units, NULL, best) < best) {
        *coder = WIRE_RUNS;
        return encode_runs(pixels, unit, units, to, best);
    }
    *coder = bytes > 0 ? WIRE_PREDICT : WIRE_RAW;
    return bytes > 0 ? bytes : encode_raw(pixels, raw, to, room);
}
