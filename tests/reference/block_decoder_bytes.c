/* block_decoder_bytes - bits, numbers and checksums, one bit at a time
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/block_decoder_bytes.h"

#include <string.h>

static uint32_t one_bit(decoder_bytes *bytes, size_t bit) {
    if (bit / 8 >= bytes->size) {
        bytes->overrun = 1;
        return 0;
    }
    return (uint32_t)bytes->at[bit / 8] >> bit % 8 & 1u;
}

uint32_t decoder_bits(decoder_bytes *bytes, size_t bit, unsigned width) {
    uint32_t number = 0;
    for (unsigned i = 0; i < width; i++) {
        number |= one_bit(bytes, bit + i) << i;
    }
    return number;
}

uint32_t decoder_u16(decoder_bytes *bytes, size_t at) {
    return decoder_bits(bytes, 8 * at, 16);
}

uint32_t decoder_u32(decoder_bytes *bytes, size_t at) {
    return decoder_bits(bytes, 8 * at, 32);
}

float decoder_float(decoder_bytes *bytes, size_t at) {
    const uint32_t word = decoder_u32(bytes, at);
    float number;
    memcpy(&number, &word, sizeof number);
    return number;
}

uint32_t decoder_ones(decoder_bytes *bytes, size_t string, uint32_t from, uint32_t to) {
    uint32_t ones = 0;
    for (uint32_t i = from; i < to; i++) {
        ones += one_bit(bytes, string + i);
    }
    return ones;
}

int decoder_is_zero(decoder_bytes *bytes, size_t from, size_t to) {
    for (size_t bit = from; bit < to; bit++) {
        if (one_bit(bytes, bit) != 0) {
            return 0;
        }
    }
    return 1;
}

unsigned decoder_width(uint32_t x) {
    unsigned width = 0;
    while (width < 32 && x >> width != 0) {
        width++;
    }
    return width;
}

uint32_t decoder_crc(const unsigned char *bytes, size_t size, size_t hole, size_t hole_bytes) {
    uint32_t crc = 0xFFFFFFFFu;
    for (size_t i = 0; i < size; i++) {
        const int in_hole = i >= hole && i < hole + hole_bytes;
        crc ^= in_hole ? 0u : bytes[i];
        for (int bit = 0; bit < 8; bit++) {
            crc = crc & 1u ? crc >> 1 ^ 0xEDB88320u : crc >> 1;
        }
    }
    return ~crc;
}
