/* wide - see wide.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/wide.h"

#include "engine/base/float_bits.h"

enum { LOWEST = -447 }; /* the power of two of bit 0: three times that of a subnormal */

/* |x| = mantissa * 2^(place - 149) */
static uint32_t mantissa_of(uint32_t bits) {
    return (bits & 0x7FFFFFu) | (uint32_t)((bits & 0x7F800000u) != 0) << 23;
}

static unsigned place_of(uint32_t bits) {
    const unsigned exponent = bits >> 23 & 0xFFu;
    return exponent - (exponent != 0);
}

/* Adds or takes away word[0 .. 3], which begin at limb `first`. */
static void add_words(plt_wide *sum, const uint32_t word[4], unsigned first, unsigned is_negative) {
    const uint32_t flip = 0u - is_negative; /* minus x is the complement of x, plus 1 */
    uint64_t carry = is_negative;
    unsigned at = first;
    for (unsigned i = 0; i < 4 && at < PLT_WIDE_LIMBS; i++, at++) {
        carry += (uint64_t)sum->limb[at] + (word[i] ^ flip);
        sum->limb[at] = (uint32_t)carry;
        carry >>= 32;
    }
    for (; at < PLT_WIDE_LIMBS && carry != is_negative; at++) { /* until nothing changes */
        carry += (uint64_t)sum->limb[at] + flip;
        sum->limb[at] = (uint32_t)carry;
        carry >>= 32;
    }
}

void plt_wide_add(plt_wide *sum, float a, float b, float c) {
    const uint32_t x = plt_bits_of(a), y = plt_bits_of(b), z = plt_bits_of(c);
    const uint64_t xy = (uint64_t)mantissa_of(x) * mantissa_of(y);
    const uint32_t third = mantissa_of(z);
    if (xy == 0 || third == 0) {
        return;
    }
    const unsigned place = place_of(x) + place_of(y) + place_of(z), shift = place & 31u;
    const uint64_t low = (xy & 0xFFFFFFFFu) * third;
    const uint64_t high = (xy >> 32) * third + (low >> 32); /* 72 bits in all */
    const uint64_t lowest = (low & 0xFFFFFFFFu) << shift;
    const uint64_t middle = ((high & 0xFFFFFFFFu) << shift) + (lowest >> 32);
    const uint64_t highest = ((high >> 32) << shift) + (middle >> 32);
    const uint32_t word[4] = {(uint32_t)lowest, (uint32_t)middle, (uint32_t)highest,
                              (uint32_t)(highest >> 32)};
    add_words(sum, word, place >> 5, (x ^ y ^ z) >> 31);
}

/* To its magnitude; returns whether it was negative. */
static int make_positive(plt_wide *sum) {
    const uint32_t flip = 0u - (sum->limb[PLT_WIDE_LIMBS - 1] >> 31);
    uint32_t carry = flip & 1u;
    for (int i = 0; i < PLT_WIDE_LIMBS; i++) {
        sum->limb[i] = (sum->limb[i] ^ flip) + carry;
        carry &= (uint32_t)(sum->limb[i] == 0);
    }
    return flip != 0;
}

plt_scaled plt_wide_value(plt_wide *sum) {
    const int is_negative = make_positive(sum);
    plt_scaled r = {0.0f, 0};
    int top = PLT_WIDE_LIMBS - 1;
    while (top >= 0 && sum->limb[top] == 0) {
        top--;
    }
    if (top < 0) {
        return r;
    }
    const uint64_t bits = (uint64_t)sum->limb[top] << 32 | (top > 0 ? sum->limb[top - 1] : 0u);
    const int zeros = __builtin_clz(sum->limb[top]);
    const float size = (float)(int32_t)(bits << zeros >> 33) * 9.31322574615478515625e-10f;
    r.mantissa = is_negative ? -size : size; /* the highest 31 bits, times 2^-30 */
    r.exponent = LOWEST + 32 * top + 31 - zeros;
    return r;
}

static float power_of_two(int exponent) { /* -126 .. 127 */
    return plt_float_of((uint32_t)(exponent + 127) << 23);
}

float plt_scaled_float(plt_scaled x, int exponent) {
    int e = x.exponent + exponent;
    e = e > 126 ? 126 : (e < -180 ? -180 : e);
    return x.mantissa * power_of_two(e / 2) * power_of_two(e - e / 2);
}
