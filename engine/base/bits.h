/* bits - strings of bits in memory, least significant bit first
 *
 * Readers may look at up to PLT_BITS_BEHIND bytes behind the bits they were asked for.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BASE_BITS_H
#define PLT_BASE_BITS_H

#include <stdint.h>

#include "engine/base/bytes.h"

#define PLT_BITS_BEHIND 8

static inline uint32_t plt_count_bits(uint32_t x) {
#if defined(__POPCNT__)
    return (uint32_t)__builtin_popcount(x);
#else
    x -= x >> 1 & 0x55555555u;
    x = (x & 0x33333333u) + (x >> 2 & 0x33333333u);
    return ((x + (x >> 4)) & 0x0F0F0F0Fu) * 0x01010101u >> 24;
#endif
}

static inline uint32_t plt_count_bits_long(uint64_t x) {
#if defined(__POPCNT__)
    return (uint32_t)__builtin_popcountll(x);
#elif UINTPTR_MAX > 0xFFFFFFFFu
    x -= x >> 1 & 0x5555555555555555u;
    x = (x & 0x3333333333333333u) + (x >> 2 & 0x3333333333333333u);
    return (uint32_t)(((x + (x >> 4)) & 0x0F0F0F0F0F0F0F0Fu) * 0x0101010101010101u >> 56);
#else
    return plt_count_bits((uint32_t)x) + plt_count_bits((uint32_t)(x >> 32));
#endif
}

/* Of both words. */
static inline uint32_t plt_count_bits_two(uint64_t x, uint64_t y) {
#if !defined(__POPCNT__) && UINTPTR_MAX > 0xFFFFFFFFu
    const uint64_t twos = 0x3333333333333333u, fours = 0x0F0F0F0F0F0F0F0Fu;
    x -= x >> 1 & 0x5555555555555555u;
    y -= y >> 1 & 0x5555555555555555u;
    x = (x & twos) + (x >> 2 & twos) + (y & twos) + (y >> 2 & twos); /* at most 8 in four bits */
    return (uint32_t)(((x & fours) + (x >> 4 & fours)) * 0x0101010101010101u >> 56);
#else
    return plt_count_bits_long(x) + plt_count_bits_long(y);
#endif
}

/* The lowest `count` bits of a word (0 .. 32). */
static inline uint32_t plt_low_bits(uint32_t count) {
    return count >= 32 ? 0xFFFFFFFFu : (1u << count) - 1u;
}

#define PLT_BITS_LONG 57

/* At least PLT_BITS_LONG bits from bit `at`. */
static inline uint64_t plt_bits_long(const unsigned char *bytes, uint32_t at) {
    return plt_get_u64(bytes + (at >> 3)) >> (at & 7);
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

#define PLT_BITS_SHORT 25

/* `width` (0 .. PLT_BITS_SHORT) bits from bit `at`: they are in one word from the byte that they
 * begin in. */
static inline uint32_t plt_bits_short(const unsigned char *bytes, uint32_t at, uint32_t width) {
    return plt_get_u32(bytes + (at >> 3)) >> (at & 7) & ((1u << width) - 1u);
}

/* Ones among the bits begin .. end - 1; begin <= end. */
static inline uint32_t plt_bits_count(const unsigned char *bytes, uint32_t begin, uint32_t end) {
    if (end - begin <= PLT_BITS_LONG) {
        return plt_count_bits_long(plt_bits_long(bytes, begin) &
                                   (((uint64_t)1 << (end - begin)) - 1));
    }
    const unsigned char *at = bytes + (begin >> 3);
    uint64_t wanted = ~(uint64_t)0 << (begin & 7); /* of the first word */
    uint32_t count = 0, left = end - (begin & ~7u);
    for (; left >= 64; left -= 64, at += 8) {
        count += plt_count_bits_long(plt_get_u64(at) & wanted);
        wanted = ~(uint64_t)0;
    }
    return count + plt_count_bits_long(plt_get_u64(at) & wanted & (((uint64_t)1 << left) - 1));
}

/* Running ranks of the string begin .. end - 1, one per 64 bits from the byte it begins
 * in, PLT_RANKS(its bits) at most; returns its ones. */
#define PLT_RANKS(bits) (((bits) + 7) / 64 + 1)

static inline uint32_t plt_ranks_open(const unsigned char *bytes, uint32_t begin, uint32_t end,
                                      uint16_t before[]) {
    const unsigned char *at = bytes + (begin >> 3);
    uint32_t left = end - (begin & ~7u);
    uint32_t ones = 0u - plt_count_bits(*at & plt_low_bits(begin & 7)); /* not of the string */
    *before = (uint16_t)ones;
    for (; left >= 64; left -= 64, at += 8) {
        ones += plt_count_bits_long(plt_get_u64(at));
        *++before = (uint16_t)ones;
    }
    return ones + plt_count_bits_long(plt_get_u64(at) & (((uint64_t)1 << left) - 1));
}

/* Ones among the first `count` bits of the string that begins at bit `begin`. */
static inline uint32_t plt_ranks_find(const unsigned char *bytes, uint32_t begin,
                                      const uint16_t before[], uint32_t count) {
    const uint32_t at = (begin & 7) + count;
    const uint64_t word = plt_get_u64(bytes + (begin >> 3) + 8 * (at >> 6));
    const uint64_t below = ((uint64_t)1 << (at & 63)) - 1;
    return (uint16_t)(before[at >> 6] + plt_count_bits_long(word & below));
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
#ifdef __GNUC__
    return most == 0 ? 0 : 32 - (uint32_t)__builtin_clz(most);
#else
    uint32_t bits = 0;
    for (; most != 0; most >>= 1) {
        bits++;
    }
    return bits;
#endif
}

#endif
