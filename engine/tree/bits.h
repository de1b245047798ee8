/* bits - strings of bits in memory, least significant bit first
 *
 * Readers may look at up to 8 bytes behind the bits they were asked for.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_BITS_H
#define PLT_TREE_BITS_H

#include <stdint.h>
#include <string.h>

#include "engine/image/bytes.h"

static inline uint32_t plt_count_bits(uint32_t x) {
#if defined(__POPCNT__)
    return (uint32_t)__builtin_popcount(x);
#else
    x -= x >> 1 & 0x55555555u;
    x = (x & 0x33333333u) + (x >> 2 & 0x33333333u);
    return ((x + (x >> 4)) & 0x0F0F0F0Fu) * 0x01010101u >> 24;
#endif
}

/* The lowest `count` bits of a word (0 .. 32). */
static inline uint32_t plt_low_bits(uint32_t count) {
    return count >= 32 ? 0xFFFFFFFFu : (1u << count) - 1u;
}

/* At least 57 bits from bit `at`. */
static inline uint64_t plt_bits_long(const unsigned char *bytes, uint32_t at) {
    const unsigned char *byte = bytes + (at >> 3);
    return ((uint64_t)plt_get_u32(byte + 4) << 32 | plt_get_u32(byte)) >> (at & 7);
}

/* 32 bits from bit `at` of the string. */
static inline uint32_t plt_bits_word(const unsigned char *bytes, uint32_t at) {
#if UINTPTR_MAX > 0xFFFFFFFFu
    return (uint32_t)plt_bits_long(bytes, at);
#else
    const uint32_t low = plt_get_u32(bytes + (at >> 3));
    const uint32_t high = bytes[(at >> 3) + 4];
    return (at & 7) == 0 ? low : low >> (at & 7) | high << (32 - (at & 7));
#endif
}

/* `width` (0 .. 32) bits from bit `at`. */
static inline uint32_t plt_bits_get(const unsigned char *bytes, uint32_t at, uint32_t width) {
    return plt_bits_word(bytes, at) & plt_low_bits(width);
}

/* Ones among the bits begin .. end - 1. */
static inline uint32_t plt_bits_count(const unsigned char *bytes, uint32_t begin, uint32_t end) {
    uint32_t count = 0;
    for (; begin + 32 <= end; begin += 32) {
        count += plt_count_bits(plt_bits_word(bytes, begin));
    }
    return begin < end ? count + plt_count_bits(plt_bits_get(bytes, begin, end - begin)) : count;
}

/* Puts `width` (0 .. 32) bits at bit `at` of a string that is zero from there. */
static inline void plt_bits_put(unsigned char *bytes, uint32_t at, uint32_t width, uint32_t value) {
    uint64_t shifted = (uint64_t)(value & plt_low_bits(width)) << (at & 7);
    for (uint32_t i = at >> 3; shifted != 0; i++, shifted >>= 8) {
        bytes[i] |= (unsigned char)shifted;
    }
}

/* Bits that numbers 0 .. most take. */
static inline uint32_t plt_bits_for(uint32_t most) {
    uint32_t bits = 0;
    for (; most != 0; most >>= 1) {
        bits++;
    }
    return bits;
}

#endif
