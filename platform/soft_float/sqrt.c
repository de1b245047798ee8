/* sqrt - the square root of a CPU without an FPU, correctly rounded
 *
 * Digit by digit in integers: 24 digits of the root and one to round by, as a root of
 * 24 bits never lies halfway between two others. libgcc has no square root, and that of a C library
 * may set errno.
 *
 * SPDX-License-Identifier: MIT */
#include <stdint.h>
#include <string.h>

enum { MANTISSA_BITS = 23, EXPONENT_BIAS = 127, INFINITE = 0x7F800000 };

float sqrtf(float x);

static float of_bits(uint32_t bits) {
    float f;
    memcpy(&f, &bits, sizeof f);
    return f;
}

/* Of m / 2^30, from 1 to below 4: 25 digits of the root, and a bit that is 0 if it has no more. */
static uint32_t root_of(uint32_t m) {
    uint32_t root = 0, rest = 0;
    for (int step = 0; step < 25; step++) {
        rest = rest << 2 | m >> 30;
        m <<= 2;
        root <<= 1;
        if (rest > 2 * root) {
            rest -= 2 * root + 1;
            root++;
        }
    }
    return root << 1 | (rest != 0);
}

/* x > 0 and finite: its mantissa, times two where the exponent is odd, and half the exponent. */
static float root_of_positive(uint32_t bits) {
    int exponent = (int)(bits >> MANTISSA_BITS);
    uint32_t m = bits & 0x7FFFFFu;
    if (exponent == 0) {
        for (exponent = 1; !(m & 0x800000u); exponent--) {
            m <<= 1;
        }
    }
    m |= 0x800000u;
    exponent -= EXPONENT_BIAS;
    m <<= exponent & 1 ? 8 : 7;
    const uint32_t root = root_of(m); /* 24 digits, one to round by, and whether more follow */
    const uint32_t odd = root >> 2 & 1u, up = root >> 1 & 1u & (root | odd);
    const uint32_t mantissa = (root >> 2) + up;
    return of_bits(((uint32_t)((exponent >> 1) + EXPONENT_BIAS - 1) << MANTISSA_BITS) + mantissa);
}

float sqrtf(float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    if ((bits & 0x7FFFFFFFu) == 0 || bits == INFINITE || (bits & 0x7FFFFFFFu) > INFINITE) {
        return x; /* zeros, infinity, not a number */
    }
    return bits >> 31 ? of_bits(0x7FC00000u) : root_of_positive(bits);
}
