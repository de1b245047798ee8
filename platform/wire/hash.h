/* hash - of a tile's pixels, to see that they changed; never sent
 *
 * Each word goes through a one-to-one mapping, so that tiles which differ in
 * one word only never have the same hash; others do once in 2^32. A word at a time,
 * it costs about a quarter of the checksum. SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_HASH_H
#define PLT_WIRE_HASH_H

#include <stddef.h>
#include <stdint.h>

static inline uint32_t wire_hash_word(uint32_t hash, uint32_t word) {
    hash = (hash ^ word) * 0x9E3779B1u; /* golden ratio */
    return hash ^ hash >> 15;
}

static inline uint32_t wire_hash(const uint8_t *at, size_t count) {
    uint32_t hash = 0;
    for (; count >= 4; at += 4, count -= 4) {
        hash = wire_hash_word(hash, at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 |
                                        (uint32_t)at[3] << 24);
    }
    for (; count > 0; at++, count--) {
        hash = wire_hash_word(hash, *at);
    }
    return hash;
}

#endif
