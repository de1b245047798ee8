/* test_crc32 - checksums are those of the definition, whatever the length and the address
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/crc32_long.h"
#include "engine/planelet_crc32.h"
#include "tests/reference/random.h"
#include "tests/test.h"

enum { MOST = 9000, SHORT = 80 };

static unsigned char message[MOST + 8];
static uint32_t scratch[2048];

/* Bit by bit, as ISO 3309 defines it. */
static uint32_t by_bits(uint32_t crc, const unsigned char *bytes, size_t count) {
    crc = ~crc;
    for (size_t i = 0; i < count; i++) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++) {
            crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0);
        }
    }
    return ~crc;
}

static void single_bits(void) {
    static unsigned char bit[16];
    unsigned wrong = 0;
    for (size_t i = 0; i < 8 * sizeof bit; i++) {
        bit[i / 8] = (unsigned char)(1u << i % 8);
        wrong += plt_crc32(0, bit, sizeof bit) != by_bits(0, bit, sizeof bit);
        bit[i / 8] = 0;
    }
    CHECK(wrong == 0, "%u of 128 single bits differ", wrong);
}

static void every_length(void) {
    unsigned wrong = 0;
    for (size_t at = 0; at < 8; at++) {
        for (size_t count = 0; count <= SHORT; count++) {
            wrong += plt_crc32(7, message + at, count) != by_bits(7, message + at, count);
        }
    }
    CHECK(wrong == 0, "%u of %d differ", wrong, 8 * (SHORT + 1));
}

static void every_split(void) {
    const uint32_t due = by_bits(0, message, SHORT);
    unsigned wrong = 0;
    for (size_t first = 0; first <= SHORT; first++) {
        const uint32_t crc = plt_crc32(0, message, first);
        wrong += plt_crc32(crc, message + first, SHORT - first) != due;
    }
    CHECK(wrong == 0, "%u of %d differ", wrong, SHORT + 1);
}

static void long_ones(void) {
    unsigned wrong = 0;
    for (size_t count = 4700; count < MOST; count += 97) {
        for (size_t words = 400; words <= 2048; words += 412) {
            wrong += plt_crc32_long(message + 1, count, scratch, words) !=
                     by_bits(0, message + 1, count);
        }
    }
    CHECK(wrong == 0, "%u differ", wrong);
}

int main(void) {
    random_state r = {1};
    for (size_t i = 0; i < sizeof message; i++) {
        message[i] = (unsigned char)random_bits(&r);
    }
    test("the check value of the definition");
    CHECK(plt_crc32(0, "123456789", 9) == 0xCBF43926u, "another");
    test("each single bit of a message");
    single_bits();
    test("all lengths at all addresses");
    every_length();
    test("a message in two parts");
    every_split();
    test("long messages, with little scratch and much");
    long_ones();
    return test_done();
}
