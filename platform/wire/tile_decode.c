/* tile_decode - bytes of a tile to rows of pixels, in pieces of any size
 *
 * Invariants, for any bytes: at most `coded` of them are read, at most
 * `height` rows reported, the reader's buffers never left; wire_tile_read
 * ends after as many steps as there are bytes, and 50 bits per pixel.
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "platform/wire/model_code.h"
#include "platform/wire/wire_tile.h"

int wire_tile_begin(wire_tile_reader *r, wire_tile_shape shape, unsigned coder, uint32_t coded,
                    const uint8_t *old, uint32_t old_stride) {
    const uint32_t raw = wire_tile_bytes(shape);
    if (raw == 0 || coder >= WIRE_CODERS || coded == 0 || coded > raw) {
        return -1;
    }
    memset(r, 0, sizeof *r);
    r->shape = shape;
    r->old = old;
    r->old_stride = old_stride;
    r->coder = (uint8_t)coder;
    r->left = (uint16_t)coded;
    r->range.mask = WIRE_HELD_BYTES - 1;
    r->unit = (uint8_t)wire_unit_bytes(shape.format);
    const int is_valid = coder == WIRE_RAW     ? coded == raw
                         : coder == WIRE_SOLID ? coded == r->unit
                                               : 1;
    return is_valid ? 0 : -1;
}

static uint32_t row_bytes(const wire_tile_reader *r) {
    return wire_row_bytes(r->shape.format, r->shape.width);
}

/* The next byte of the tile, or -1 when there is none yet. */
static int next_byte(wire_tile_reader *r, const uint8_t **at, const uint8_t *end) {
    if (*at == end || r->left == 0) {
        return -1;
    }
    r->left--;
    return *(*at)++;
}

/* ---- raw, solid, runs: bytes of rows ------------------------------------------- */

static uint8_t *repeated(wire_tile_reader *r) {
    return r->as.row + WIRE_ROW_BYTES_MAX;
}

/* A byte for the row, from the pixel that repeats or from the stream; -1:
 * there is none yet. */
static int plain_byte(wire_tile_reader *r, const uint8_t **at, const uint8_t *end) {
    if (r->coder == WIRE_RAW) {
        return next_byte(r, at, end);
    }
    if (!r->is_run) {
        const int byte = next_byte(r, at, end);
        if (byte >= 0 && ++r->held == r->unit) {
            r->held = 0;
            r->run--;
        }
        return byte;
    }
    while (r->started < r->unit) { /* the pixel that repeats comes first */
        const int byte = next_byte(r, at, end);
        if (byte < 0) {
            return -1;
        }
        repeated(r)[r->started++] = (uint8_t)byte;
    }
    const int byte = repeated(r)[r->held];
    if (++r->held == r->unit) {
        r->held = 0;
        r->run--;
    }
    return byte;
}

/* Starts the next run when the last is used up; 0: its head is not there. */
static int have_run(wire_tile_reader *r, const uint8_t **at, const uint8_t *end) {
    if (r->coder == WIRE_RAW || r->run > 0) {
        return 1;
    }
    if (r->coder == WIRE_SOLID) {
        r->is_run = 1;
        r->run = 255; /* a tile has 256 units at most; refilled without a head */
        return 1;
    }
    const int head = next_byte(r, at, end);
    if (head < 0) {
        return 0;
    }
    r->is_run = head >= 128;
    r->run = (uint8_t)(head >= 128 ? head - 126 : head + 1);
    r->started = r->held = 0;
    return 1;
}

/* A row may end within a run; a tile that ends within one is wrong, which
 * shows by its length or here. */
static int read_plain(wire_tile_reader *r, const uint8_t **at, const uint8_t *end) {
    const uint32_t most = row_bytes(r);
    while (r->row_used < most) {
        const int byte = have_run(r, at, end) ? plain_byte(r, at, end) : -1;
        if (byte < 0) {
            return r->left == 0 ? WIRE_TILE_WRONG : WIRE_TILE_MORE;
        }
        r->as.row[r->row_used++] = (uint8_t)byte;
    }
    r->row_used = 0;
    r->y++;
    return WIRE_TILE_ROW;
}

/* ---- predicted ------------------------------------------------------------------- */

_Static_assert((int)MODEL_PIXEL_BYTES <= (int)WIRE_HELD_BYTES, "a pixel is decoded whole");

/* As many bytes as can be held. 1: enough for a pixel, or all there are. */
static int hold_bytes(wire_tile_reader *r, const uint8_t **at, const uint8_t *end) {
    wire_range *c = &r->range;
    while (c->room - c->used < WIRE_HELD_BYTES && r->left > 0) {
        if (*at == end) {
            return 0;
        }
        r->held_bytes[c->room++ % WIRE_HELD_BYTES] = *(*at)++;
        r->left--;
    }
    return 1;
}

/* The flags, then four bytes of code; 0: no encoder makes such flags. */
static int start_predicted(wire_tile_reader *r) {
    wire_range *c = &r->range;
    const unsigned flags = r->held_bytes[c->used++ % WIRE_HELD_BYTES], near = flags & MODEL_NEAR;
    if ((flags & MODEL_DELTA && r->old == NULL) || flags > MODEL_FLAGS || near > WIRE_NEAR_MOST ||
        (near > 0 && r->shape.format >= WIRE_GREY4)) {
        return 0;
    }
    wire_model_start(&r->as.model, r->shape, flags);
    for (int i = 0; i < 4; i++) {
        wire_range_get(c);
    }
    c->range = UINT32_MAX;
    r->started = 1;
    return 1;
}

static void read_pixel(wire_tile_reader *r) {
    wire_model *m = &r->as.model;
    wire_sample old = {{0, 0, 0, 0}}, pixel = {{0, 0, 0, 0}};
    if (m->flags & MODEL_DELTA) {
        old = wire_sample_get(m->format, r->old + (size_t)r->y * r->old_stride, m->x);
    }
    wire_code_pixel(m, &r->range, WIRE_DECODES, &old, &pixel);
}

static int read_predicted(wire_tile_reader *r, const uint8_t **at, const uint8_t *end) {
    r->range.bytes = r->held_bytes;
    while (hold_bytes(r, at, end)) {
        if (!r->started) {
            if (!start_predicted(r)) {
                return WIRE_TILE_WRONG;
            }
            continue; /* the first pixel, too, may need all that can be held */
        }
        read_pixel(r);
        if (r->as.model.x == 0) {
            r->y++;
            return WIRE_TILE_ROW;
        }
    }
    return WIRE_TILE_MORE;
}

int wire_tile_read(wire_tile_reader *r, const uint8_t **at, const uint8_t *end) {
    if (r->y == r->shape.height) {
        /* The predicted tile's last byte or two may not have been needed. */
        const uint32_t there = (uint32_t)(end - *at), rest = r->left < there ? r->left : there;
        *at += rest;
        r->left = (uint16_t)(r->left - rest);
        return r->left == 0 ? WIRE_TILE_DONE : WIRE_TILE_MORE;
    }
    return r->coder == WIRE_PREDICT ? read_predicted(r, at, end) : read_plain(r, at, end);
}

void wire_tile_row(const wire_tile_reader *r, uint8_t *to) {
    if (r->coder != WIRE_PREDICT) {
        memcpy(to, r->as.row, row_bytes(r));
        return;
    }
    wire_samples_put(r->shape.format, to, r->shape.width, r->as.model.row);
}
