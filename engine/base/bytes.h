/* bytes - little-endian words at any address of an image
 *
 * An image is the same on every machine; these are plain loads and stores
 * where the machine is little-endian too.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BASE_BYTES_H
#define PLT_BASE_BYTES_H

#include <stdint.h>
#include <string.h>

#include "engine/base/float_bits.h"

static inline uint32_t plt_swap_if_big(uint32_t x) {
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    return x >> 24 | (x >> 8 & 0xFF00u) | (x << 8 & 0xFF0000u) | x << 24;
#else
    return x;
#endif
}

static inline uint32_t plt_get_u32(const void *at) {
    uint32_t x;
    memcpy(&x, at, sizeof x);
    return plt_swap_if_big(x);
}

static inline uint64_t plt_get_u64(const void *at) {
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    uint64_t x;
    memcpy(&x, at, sizeof x);
    return x;
#else
    const unsigned char *byte = at;
    return (uint64_t)plt_get_u32(byte + 4) << 32 | plt_get_u32(byte);
#endif
}

static inline void plt_put_u32(void *at, uint32_t x) {
    x = plt_swap_if_big(x);
    memcpy(at, &x, sizeof x);
}

/* In one load where no bytes are swapped: by way of an integer it would take two instructions
 * and a register more. */
static inline float plt_get_float(const void *at) {
    float x;
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    x = plt_float_of(plt_get_u32(at));
#else
    memcpy(&x, at, sizeof x);
#endif
    return x;
}

static inline void plt_put_float(void *at, float x) {
    plt_put_u32(at, plt_bits_of(x));
}

static inline void plt_get_floats(float *to, const unsigned char *at, unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        to[i] = plt_get_float(at + 4 * i);
    }
}

static inline void plt_put_floats(unsigned char *at, const float *from, unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        plt_put_float(at + 4 * i, from[i]);
    }
}

#endif
