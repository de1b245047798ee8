/* srgb - light to the bytes of a picture
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BASE_SRGB_H
#define PLT_BASE_SRGB_H

#include <stdint.h>

/* The sRGB byte of linear light (IEC 61966-2-1), 1 and more being white. In place of x^(1 / 2.4)
 * there is a sum of square roots, least squares made even (Lawson 1961): off by at most 0.027 of a
 * byte's step, before it is rounded to nearest. A NaN is black. */
static inline uint8_t plt_srgb_byte(float x) {
    if (!(x > 0.0f)) {
        return 0;
    }
    const float light = x < 1.0f ? x : 1.0f;
    if (light <= 0.0031308f) {
        return (uint8_t)(int32_t)(light * (12.92f * 255.0f) + 0.5f);
    }
    const float s = __builtin_sqrtf(light), q = __builtin_sqrtf(s);
    const float curve = -0.0705103923f + 0.91270287f * s + 0.254492251f * q +
                        light * (-0.132227787f + 0.0356430658f * s);
    return (uint8_t)(int32_t)(curve * 255.0f + 0.5f);
}

#endif
