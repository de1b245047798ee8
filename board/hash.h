/* hash - 64-bit FNV-1a, the hash of frames (Fowler, Noll, Vo, 1991)
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_HASH_H
#define PLT_BOARD_HASH_H

#include <stddef.h>
#include <stdint.h>

static inline uint64_t hash_bytes(const uint8_t *bytes, size_t count) {
    uint64_t hash = 0xCBF29CE484222325u;
    for (size_t i = 0; i < count; i++) {
        hash = (hash ^ bytes[i]) * 0x100000001B3u;
    }
    return hash;
}

#endif
