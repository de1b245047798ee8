/* test_wire_pixels - the longest pixels of a predicted tile, in pieces of any size
 *
 * The reader holds as many bytes as a pixel may take and decodes none before
 * that many are there. Which pieces the bytes come in must not matter, whatever
 * the chances are; those of a new tile leave its first pixel far below the bound,
 * so they are set to both of their limits here.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/model_code.h"
#include "platform/wire/wire_tile.h"
#include "tests/reference/random.h"
#include "tests/test.h"

typedef struct coded {
    wire_tile_shape shape;
    uint8_t old[WIRE_TILE_BYTES_MAX], bytes[WIRE_TILE_BYTES_MAX];
    uint32_t count;
} coded;

static void set_chances(wire_model *m, uint16_t chance) {
    for (unsigned i = 0; i < MODEL_CHANCES; i++) {
        m->chance[i] = chance;
    }
}

/* All of the code at hand: what the pieces must come to. Returns the most bytes
 * that a pixel took. */
static uint32_t decode_whole(const coded *c, uint16_t chance, uint8_t *to) {
    const uint32_t stride = wire_row_bytes(c->shape.format, c->shape.width);
    uint8_t code[WIRE_TILE_BYTES_MAX];
    memcpy(code, c->bytes + 1, c->count - 1);
    wire_range range = {code, UINT32_MAX, 0, 0, c->count - 1, 0};
    wire_model m;
    uint32_t most = 0;
    for (int i = 0; i < 4; i++) {
        wire_range_get(&range);
    }
    range.range = UINT32_MAX;
    wire_model_start(&m, c->shape, c->bytes[0]);
    set_chances(&m, chance);
    for (unsigned n = 0; n < 256; n++) {
        const uint32_t before = range.used;
        wire_sample old = wire_sample_get(c->shape.format, c->old + n / 16 * stride, n % 16), pixel;
        memset(&pixel, 0, sizeof pixel);
        wire_code_pixel(&m, &range, WIRE_DECODES, &old, &pixel);
        wire_sample_put(c->shape.format, to + n / 16 * stride, n % 16, pixel);
        most = range.used - before > most ? range.used - before : most;
    }
    return most;
}

/* The same by the reader, in pieces, with these chances from its start on. */
static void decode_pieces(const coded *c, uint16_t chance, uint32_t piece, uint8_t *to) {
    const uint32_t stride = wire_row_bytes(c->shape.format, c->shape.width);
    wire_tile_reader r;
    const uint8_t *at = c->bytes;
    wire_tile_begin(&r, c->shape, WIRE_PREDICT, c->count, c->old, stride);
    CHECK(wire_tile_read(&r, &at, c->bytes + WIRE_HELD_BYTES) == WIRE_TILE_MORE && r.started &&
              r.as.model.x == 0,
          "a pixel was decoded with less than all that can be held");
    set_chances(&r.as.model, chance);
    for (uint32_t end = WIRE_HELD_BYTES; end < c->count;) {
        end = end + piece < c->count ? end + piece : c->count;
        while (wire_tile_read(&r, &at, c->bytes + end) == WIRE_TILE_ROW) {
            wire_tile_row(&r, to + (r.y - 1u) * stride);
        }
    }
    CHECK(r.y == 16, "%u rows", r.y);
}

/* Ones where all chances expect zeros, and the reverse; noise. */
static void test_longest_pixels(void) {
    static const uint16_t limits[] = {WIRE_CHANCE_LEAST, WIRE_CHANCE_MOST};
    random_state random = {5};
    uint32_t most = 0;
    test("pixels of the most bytes come out of any pieces as out of the whole, the first as all");
    for (unsigned n = 0; n < 3 * 2 * 3; n++) { /* formats, limits, codes */
        coded c = {.shape = {(uint8_t)(n % 3), 16, 16}};
        uint8_t whole[WIRE_TILE_BYTES_MAX], got[WIRE_TILE_BYTES_MAX];
        c.count = wire_tile_bytes(c.shape);
        for (unsigned i = 0; i < c.count; i++) {
            c.old[i] = (uint8_t)random_below(&random, 256);
            c.bytes[i] = (uint8_t)(n / 6 == 0 ? 0xFF : n / 6 == 1 ? 0 : random_below(&random, 256));
        }
        c.bytes[0] = MODEL_DELTA;
        const uint32_t bytes = decode_whole(&c, limits[n / 3 % 2], whole);
        most = bytes > most ? bytes : most;
        for (uint32_t piece = 1; piece <= c.count; piece += c.count - 1) {
            memset(got, 0x5A, sizeof got);
            decode_pieces(&c, limits[n / 3 % 2], piece, got);
            CHECK(memcmp(got, whole, c.count) == 0, "case %u, pieces of %u", n, piece);
        }
    }
    CHECK(most > 24 && most <= MODEL_PIXEL_BYTES, "%u bytes", most);
    printf("    at most %u bytes per pixel\n", most);
}

int main(void) {
    test_longest_pixels();
    return test_done();
}
