/* test_wire_fuzz - the wire's fuzz targets with mutations of their own
 *
 * PLANELET_SOAK=1 mutates a hundred times as much.
 *
 * SPDX-License-Identifier: MIT */
#define LLVMFuzzerTestOneInput fuzz_tile
#include "tests/fuzz/fuzz_wire_tile.c"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_end
#include "tests/fuzz/fuzz_wire_peer.c"
#undef LLVMFuzzerTestOneInput

#include "tests/test.h"

#ifdef __SANITIZE_ADDRESS__
enum { TILES = 60000, SESSIONS = 4000 };
#else
enum { TILES = 300000, SESSIONS = 20000 };
#endif

/* A right tile of random content, then a few bytes changed. */
static size_t tile_input(random_state *r, uint8_t *data) {
    uint8_t pixels[WIRE_TILE_BYTES_MAX], old[WIRE_TILE_BYTES_MAX] = {0};
    data[0] = (uint8_t)random_below(r, 5);
    data[1] = (uint8_t)(1 + random_below(r, 16));
    data[2] = (uint8_t)(1 + random_below(r, 16));
    data[3] = (uint8_t)random_bits(r);
    const wire_tile_shape shape = {data[0], data[1], data[2]};
    const uint32_t noise = random_below(r, 3) ? 1 + random_below(r, 60) : 256;
    for (uint32_t i = 0; i < wire_tile_bytes(shape); i++) {
        pixels[i] = (uint8_t)(shape.format < WIRE_GREY4 ? random_below(r, noise) : 0);
    }
    unsigned coder;
    const uint32_t bytes = wire_tile_encode(shape, pixels, random_below(r, 4) ? NULL : old, 0,
                                            data + 4, WIRE_TILE_BYTES_MAX, &coder);
    data[0] = (uint8_t)(data[0] + 6 * coder);
    return 4 + bytes;
}

static void mutate(random_state *r, uint8_t *data, size_t size) {
    for (uint32_t n = random_below(r, 4); n > 0; n--) {
        uint8_t *at = data + random_below(r, (uint32_t)size);
        *at = random_below(r, 2) ? (uint8_t)random_bits(r)
                                 : (uint8_t)(*at ^ 1u << random_below(r, 8));
    }
}

/* Messages of right form and random content; every third byte stream wild. */
static size_t end_input(random_state *r, uint8_t *data, size_t room) {
    static const uint8_t types[] = {0x01, 0x02, 0x03, 0x80, 0x84, 0xA0, 0xC0, 0xE0, 0xE1, 0x12,
                                    0x13, 0x14, 0x15, 0x16, 0x17, 0x18, 0x19, 0x1A, 0x1B, 0x1C,
                                    0x1D, 0x1E, 0x1F, 0x10, 0x11, 0x40, 0x20, 0x21};
    size_t at = 1;
    data[0] = (uint8_t)random_bits(r);
    while (at + 59 < room) {
        const size_t end = at + 59;
        data[at++] =
            (uint8_t)(random_below(r, 2) << 7 | (random_below(r, 5) ? 0 : random_below(r, 60)));
        while (at + 4 < end) {
            const uint8_t type = types[random_below(r, sizeof types)];
            const uint32_t length = random_below(r, 60);
            data[at++] = type;
            data[at] = (uint8_t)random_below(r, 8);
            at += type >= 0x80;
            data[at++] = (uint8_t)length;
            for (uint32_t i = 0; i < length && at < end; i++) {
                data[at++] = (uint8_t)(random_below(r, 2) ? random_bits(r) : random_below(r, 4));
            }
        }
        at = end;
    }
    return at;
}

int main(void) {
    static uint8_t data[4096];
    const char *soak = getenv("PLANELET_SOAK");
    const unsigned long more = soak != NULL && soak[0] == '1' ? 100 : 1;
    random_state r = {42};
    test("mutated tiles decode or are refused; no row too many, no byte outside");
    for (unsigned long i = 0; i < TILES * more; i++) {
        const size_t size = tile_input(&r, data);
        mutate(&r, data, size);
        CHECK(fuzz_tile(data, random_below(&r, 20) ? size : 1 + random_below(&r, (uint32_t)size)) ==
                  0,
              "%lu", i);
    }
    test("of the mutated tiles some are whole and some are refused");
    CHECK(tiles_whole > TILES / 10 && tiles_wrong > TILES / 50, "%lu whole, %lu wrong", tiles_whole,
          tiles_wrong);
    test("sealed reports of any content harm no peer");
    for (unsigned long i = 0; i < SESSIONS * more; i++) {
        const size_t size = end_input(&r, data, 61 + random_below(&r, 600));
        mutate(&r, data, size);
        CHECK(fuzz_end(data, size) == 0, "%lu", i);
    }
    test("they were taken for reports");
    CHECK(reports_taken > SESSIONS, "%lu", reports_taken);
    return test_done();
}
