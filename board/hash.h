/* hash - 64-bit FNV-1a, the hash of frames
 *
 * Source: G. Fowler, L. C. Noll, K.-P. Vo, "The FNV Non-Cryptographic Hash
 * Algorithm", IETF draft, 1991.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_HASH_H
#define PLT_BOARD_HASH_H

#include <stddef.h>
#include <stdint.h>

/* The hash of no bytes. */
#define HASH_BASIS UINT64_C(0xCBF29CE484222325)

/* The hash of what `hash` covers followed by `bytes`; start with HASH_BASIS. */
static inline uint64_t hash_update(uint64_t hash, const uint8_t *bytes, size_t count) {
    for (size_t i = 0; i < count; i++) {
        hash = (hash ^ bytes[i]) * UINT64_C(0x100000001B3);
    }
    return hash;
}

static inline uint64_t hash_bytes(const uint8_t *bytes, size_t count) {
    return hash_update(HASH_BASIS, bytes, count);
}

#endif
