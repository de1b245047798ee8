/* retrieval - a table that gives each of its keys a value, and keeps no keys
 *
 * A key's value is the exclusive or of three entries, one of each third of the table, where hashes
 * of the key say. What it gives for other keys means nothing. A table of n keys has some 1.23 n
 * entries of the values' own size: that is all there is.
 *
 * Sources: B. S. Majewski, N. C. Wormald, G. Havas and Z. J. Czech, A Family of Perfect Hashing
 * Methods, 1996; T. M. Graf and D. Lemire, Xor Filters, 2020.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SURFACE_RETRIEVAL_H
#define PLT_SURFACE_RETRIEVAL_H

#include <stddef.h>
#include <stdint.h>

typedef struct plt_retrieval {
    const unsigned char *entry; /* 3 thirds of `third` entries each, one behind the other, bit by
                                 * bit from the lowest of a byte on */
    uint32_t third;             /* 0: there are no keys */
    uint32_t seed;
} plt_retrieval;

static inline uint32_t plt_hash_mixed(uint32_t x) {
    x ^= x >> 16;
    x *= 0x7FEB352Du;
    x ^= x >> 15;
    x *= 0x846CA68Bu;
    return x ^ x >> 16;
}

/* `hash` as a number below `third`. */
static inline uint32_t plt_hash_below(uint32_t hash, uint32_t third) {
    return (uint32_t)((uint64_t)hash * third >> 32);
}

/* The entries of a key of three words: 64 bits tell keys apart. */
static inline void plt_retrieval_places(uint32_t third, uint32_t seed, const uint32_t key[3],
                                        uint32_t place[3]) {
    uint32_t a = seed, b = seed ^ 0x55555555u;
    for (int i = 0; i < 3; i++) {
        a = (a ^ key[i]) * 0x9E3779B1u;
        a ^= a >> 15;
        b = (b + key[i]) * 0x85EBCA6Bu;
        b ^= b >> 13;
    }
    const uint32_t c = plt_hash_mixed(a ^ (b << 16 | b >> 16));
    const uint32_t d = plt_hash_mixed(a + 0x9E3779B1u * (c ^ b));
    place[0] = plt_hash_below(c, third);
    place[1] = third + plt_hash_below(d, third);
    place[2] = 2 * third + plt_hash_below(plt_hash_mixed(b + 0x85EBCA6Bu * d), third);
}

/* Bytes of so many thirds' entries. */
static inline uint64_t plt_retrieval_bytes(uint32_t third, uint32_t bits) {
    return (3 * (uint64_t)third * bits + 7) / 8;
}

/* An entry of 1 to 32 bits. */
static inline uint32_t plt_retrieval_entry(const unsigned char *entries, uint32_t bits,
                                           uint32_t place) {
    const uint32_t rest = place % 8 * bits, shift = rest % 8;
    const unsigned char *byte = entries + (size_t)(place / 8) * bits + rest / 8;
    uint32_t value = (uint32_t)*byte >> shift;
    for (uint32_t have = 8 - shift; have < bits; have += 8) {
        value |= (uint32_t) * ++byte << have;
    }
    return value & 0xFFFFFFFFu >> (32 - bits);
}

/* What a table of such entries gives for a key; it has one. */
static inline uint32_t plt_retrieval_value(const plt_retrieval *t, uint32_t bits,
                                           const uint32_t key[3]) {
    uint32_t place[3], value = 0;
    plt_retrieval_places(t->third, t->seed, key, place);
    for (int i = 0; i < 3; i++) {
        value ^= plt_retrieval_entry(t->entry, bits, place[i]);
    }
    return value;
}

#endif
