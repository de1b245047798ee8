/* test_wire_tile - the codec: what goes in comes out, and garbage does no harm
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "platform/wire/wire_tile.h"
#include "tests/reference/random.h"
#include "tests/reference/wire_picture.h"
#include "tests/test.h"

enum { CONTENTS = 9 };

typedef struct coded {
    wire_tile_shape shape;
    uint8_t pixels[WIRE_TILE_BYTES_MAX], old[WIRE_TILE_BYTES_MAX], bytes[WIRE_TILE_BYTES_MAX];
    uint32_t raw, count;
    unsigned coder;
} coded;

static unsigned colour_of(unsigned content, unsigned x, unsigned y, random_state *r) {
    switch (content) {
    case 0:
        return 0;
    case 1:
        return 0x804020;
    case 2:
        return x * 0x0F0F0F;
    case 3:
        return y * 0x0A0F05 + x * 0x010203;
    case 4:
        return (x + y) % 7 < 3 ? 0xFFFFFF : 0;
    case 5:
        return (unsigned)random_bits(r) & 0xFFFFFF;
    case 6:
        return 0x80 + random_below(r, 30) * 0x010101u;
    case 7:
        return (x - 8) * (x - 8) + (y - 8) * (y - 8) < 40 ? 0xE0D0B0 : 0x202830;
    default:
        return random_below(r, 20) ? 0x406080 : 0xFFFFFF;
    }
}

static void draw(wire_tile_shape s, unsigned content, random_state *r, uint8_t *pixels) {
    for (unsigned y = 0; y < s.height; y++) {
        uint8_t rgb[3 * WIRE_TILE_SIDE];
        for (unsigned x = 0; x < s.width; x++) {
            const unsigned c = colour_of(content, x, y, r);
            rgb[3 * x] = (uint8_t)(c >> 16), rgb[3 * x + 1] = (uint8_t)(c >> 8);
            rgb[3 * x + 2] = (uint8_t)c;
        }
        wire_row_from_rgb(pixels + y * wire_row_bytes(s.format, s.width), s.format, rgb, s.width, 0,
                          y);
    }
}

/* Decodes in pieces of `piece` bytes; rows that came, or -1 when it is wrong. */
static int decode(const coded *c, const uint8_t *bytes, uint32_t count, uint32_t piece,
                  const uint8_t *old, uint8_t *to) {
    const uint32_t row = wire_row_bytes(c->shape.format, c->shape.width);
    wire_tile_reader r;
    const uint8_t *at = bytes;
    int rows = 0;
    if (wire_tile_begin(&r, c->shape, c->coder, count, old, row) < 0) {
        return -1;
    }
    for (uint32_t end = 0; end < count;) {
        end = end + piece < count ? end + piece : count;
        int event;
        while ((event = wire_tile_read(&r, &at, bytes + end)) == WIRE_TILE_ROW) {
            wire_tile_row(&r, to + (r.y - 1u) * row);
            rows++;
        }
        if (event != WIRE_TILE_MORE) {
            return event == WIRE_TILE_DONE && end == count ? rows : -1;
        }
    }
    return -1;
}

static void check_tile(coded *c, const uint8_t *old, unsigned near, random_state *r) {
    uint8_t source[WIRE_TILE_BYTES_MAX], got[WIRE_TILE_BYTES_MAX];
    memcpy(source, c->pixels, c->raw);
    c->count = wire_tile_encode(c->shape, c->pixels, old, near, c->bytes, c->raw, &c->coder);
    CHECK(c->count > 0 && c->count <= c->raw, "%u bytes of %u", c->count, c->raw);
    CHECK(near > 0 || memcmp(source, c->pixels, c->raw) == 0, "the source was changed");
    for (uint32_t piece = 1; piece <= c->count; piece += 1 + random_below(r, 40)) {
        const int rows = decode(c, c->bytes, c->count, piece, old, got);
        CHECK(rows == c->shape.height && memcmp(got, c->pixels, c->raw) == 0,
              "format %u, %u x %u, coder %u, pieces of %u", c->shape.format, c->shape.width,
              c->shape.height, c->coder, piece);
    }
    for (unsigned y = 0; y < c->shape.height && near > 0; y++) {
        for (unsigned x = 0; x < c->shape.width; x++) {
            const uint32_t at = y * wire_row_bytes(c->shape.format, c->shape.width);
            const wire_sample a = wire_sample_get(c->shape.format, source + at, x);
            const wire_sample b = wire_sample_get(c->shape.format, got + at, x);
            for (int i = 0; i < 3; i++) {
                CHECK(abs(a.v[i] - b.v[i]) <= (int)near, "off by %d", abs(a.v[i] - b.v[i]));
            }
        }
    }
}

static coded make(unsigned format, unsigned width, unsigned height, unsigned content,
                  random_state *r) {
    coded c = {.shape = {(uint8_t)format, (uint8_t)width, (uint8_t)height}};
    c.raw = wire_tile_bytes(c.shape);
    draw(c.shape, content, r, c.pixels);
    draw(c.shape, content == 5 ? 5 : (content + random_below(r, 2)) % CONTENTS, r, c.old);
    if (random_below(r, 2)) {
        memcpy(c.old, c.pixels, c.raw / 2);
    }
    return c;
}

static void test_round_trips(void) {
    random_state r = {1};
    test(
        "every format, shape and content comes back bit for bit, in pieces of any size, with "
        "and without the old pixels");
    unsigned coders[WIRE_CODERS] = {0};
    for (unsigned format = 0; format < WIRE_FORMATS; format++) {
        for (unsigned n = 0; n < 16 * 16; n++) {
            for (unsigned content = 0; content < CONTENTS; content++) {
                coded c = make(format, 1 + n % 16, 1 + n / 16, content, &r);
                check_tile(&c, NULL, 0, &r);
                coders[c.coder]++;
                check_tile(&c, c.old, 0, &r);
            }
        }
    }
    test("each coder is the shortest at times");
    for (unsigned i = 0; i < WIRE_CODERS; i++) {
        CHECK(coders[i] > 20, "coder %u: %u times", i, coders[i]);
    }
    test("near tiles are off by their bound at most");
    for (unsigned near = 1; near <= WIRE_NEAR_MOST; near++) {
        for (unsigned content = 0; content < CONTENTS; content++) {
            coded c = make(near % 3, 16, 16, content, &r);
            check_tile(&c, near & 4 ? c.old : NULL, near, &r);
        }
    }
}

static void test_room(void) {
    random_state r = {2};
    test("with any room the encoder writes inside it or returns 0");
    for (unsigned content = 0; content < CONTENTS; content++) {
        coded c = make(WIRE_RGB565, 16, 16, content, &r);
        for (uint32_t room = 0; room <= c.raw; room++) {
            uint8_t *to = malloc(room + 1);
            to[room] = 0x5A;
            const uint32_t n = wire_tile_encode(c.shape, c.pixels, NULL, 0, to, room, &c.coder);
            CHECK(n <= room && to[room] == 0x5A, "%u of %u", n, room);
            free(to);
        }
    }
}

/* Every truncation and every flipped bit of a byte, decoded from a block of
 * just its size. */
static void test_hostile(void) {
    random_state r = {3};
    test("every truncation and every changed byte ends, in at most as many rows as there are");
    for (unsigned n = 0; n < WIRE_FORMATS * CONTENTS; n++) {
        coded c = make(n % WIRE_FORMATS, 16 - n % 3, 16 - n % 5, n / WIRE_FORMATS, &r);
        uint8_t got[WIRE_TILE_BYTES_MAX + 16];
        const uint8_t *old = n & 1 ? c.old : NULL;
        c.count = wire_tile_encode(c.shape, c.pixels, old, 0, c.bytes, c.raw, &c.coder);
        for (uint32_t cut = 1; cut <= c.count; cut++) {
            uint8_t *bytes = malloc(cut);
            memcpy(bytes, c.bytes, cut);
            memset(got + c.raw, 0x5A, 16);
            const int rows = decode(&c, bytes, cut, 7, old, got);
            CHECK(rows <= c.shape.height && got[c.raw] == 0x5A, "cut at %u: %d rows", cut, rows);
            bytes[random_below(&r, cut)] ^= (uint8_t)(1 + random_below(&r, 255));
            CHECK(decode(&c, bytes, cut, 1, old, got) <= c.shape.height && got[c.raw] == 0x5A,
                  "changed");
            free(bytes);
        }
        for (uint32_t i = 0; i < c.count; i++) {
            c.bytes[i] ^= (uint8_t)(1u << (i & 7));
            CHECK(decode(&c, c.bytes, c.count, 64, old, got) <= c.shape.height, "byte %u", i);
            c.bytes[i] ^= (uint8_t)(1u << (i & 7));
        }
    }
}

static void test_refusals(void) {
    wire_tile_reader r;
    const wire_tile_shape good = {WIRE_RGB565, 16, 16};
    test("shapes, coders and lengths out of range are refused");
    CHECK(wire_tile_begin(&r, (wire_tile_shape){5, 16, 16}, 0, 1, NULL, 0) < 0, "format");
    CHECK(wire_tile_begin(&r, (wire_tile_shape){0, 17, 1}, 0, 34, NULL, 0) < 0, "width");
    CHECK(wire_tile_begin(&r, (wire_tile_shape){0, 1, 0}, 0, 2, NULL, 0) < 0, "height");
    CHECK(wire_tile_begin(&r, good, 4, 10, NULL, 0) < 0, "coder");
    CHECK(wire_tile_begin(&r, good, WIRE_PREDICT, 0, NULL, 0) < 0, "nothing");
    CHECK(wire_tile_begin(&r, good, WIRE_RUNS, 513, NULL, 0) < 0, "more than raw");
    CHECK(wire_tile_begin(&r, good, WIRE_RAW, 511, NULL, 0) < 0, "less than raw");
    CHECK(wire_tile_begin(&r, good, WIRE_SOLID, 3, NULL, 0) < 0, "more than a pixel");
    test("a delta without a panel that can be read is refused");
    const uint8_t delta[6] = {MODEL_DELTA};
    const uint8_t *at = delta;
    CHECK(wire_tile_begin(&r, good, WIRE_PREDICT, 6, NULL, 0) == 0, "begin");
    CHECK(wire_tile_read(&r, &at, delta + 6) == WIRE_TILE_WRONG, "read");
}

static void test_golden(void) {
    const wire_tile_shape shape = {WIRE_RGB565, 16, 16};
    uint8_t pixels[512], bytes[512];
    uint32_t crc = 0;
    test("a picture has the coded bytes that it has on a Cortex-M4");
    for (unsigned tile = 0; tile < PICTURE_TILES; tile++) {
        unsigned coder;
        wire_picture_tile(tile, pixels);
        crc = plt_crc32(crc, bytes, wire_tile_encode(shape, pixels, NULL, 0, bytes, 512, &coder));
        crc = plt_crc32(crc, bytes,
                        wire_tile_encode(shape, pixels, NULL, PICTURE_NEAR, bytes, 512, &coder));
    }
    CHECK(crc == PICTURE_CODED_CRC, "their checksum is %08X", (unsigned)crc);
}

static void test_formats(void) {
    uint8_t rgb[3 * 256], row[3 * 256], back[3 * 256];
    test(
        "grey stays grey, black and white stay so in every format; the dither lights what it "
        "should");
    for (unsigned format = 0; format < WIRE_FORMATS; format++) {
        for (unsigned i = 0; i < 3 * 256; i++) {
            rgb[i] = (uint8_t)(i / 3);
        }
        wire_row_from_rgb(row, format, rgb, 256, 0, 0);
        wire_row_to_rgb(back, format, row, 256);
        for (unsigned i = 0; i < 256; i++) {
            const uint8_t *p = back + 3 * i;
            const int off = abs(p[1] - (int)i);
            CHECK(format == WIRE_MONO1 || off <= (format == WIRE_GREY4 ? 8 : 3), "%u is %u", i,
                  p[1]);
        }
        CHECK(back[1] == 0 && back[3 * 255 + 1] == 255, "format %u: %u, %u", format, back[1],
              back[3 * 255 + 1]);
    }
    for (unsigned grey = 0; grey < 256; grey++) {
        unsigned lit = 0;
        memset(rgb, (int)grey, sizeof rgb);
        for (unsigned y = 0; y < 8; y++) {
            wire_row_from_rgb(row, WIRE_MONO1, rgb, 8, 0, y);
            for (unsigned b = row[0]; b; b &= b - 1) {
                lit++;
            }
        }
        CHECK(lit == (grey + 2) / 4, "%u of 64 at %u", lit, grey);
    }
    test("rows have the bytes they should");
    CHECK(wire_row_bytes(WIRE_RGB565, 17) == 34 && wire_row_bytes(WIRE_RGB888, 16) == 48 &&
              wire_row_bytes(WIRE_GREY8, 3) == 3 && wire_row_bytes(WIRE_GREY4, 3) == 2 &&
              wire_row_bytes(WIRE_MONO1, 9) == 2 && wire_row_bytes(5, 9) == 0,
          "bytes");
}

int main(void) {
    test_formats();
    test_golden();
    test_round_trips();
    test_room();
    test_hostile();
    test_refusals();
    return test_done();
}
