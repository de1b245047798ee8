/* float_bits - a float as its 32 bits, and back
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BASE_FLOAT_BITS_H
#define PLT_BASE_FLOAT_BITS_H

#include <stdint.h>
#include <string.h>

static inline uint32_t plt_bits_of(float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline float plt_float_of(uint32_t bits) {
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

#endif
