/* optics - the arithmetic of light: directions, powers, fading, and how surfaces share a ray
 *
 * No libm but square roots: every result is the same bits on every machine. Vectors of length 1
 * have it to some 2^-22.
 *
 * Sources: C. Schlick, "An inexpensive BRDF model for physically-based rendering", 1994 (what
 * glass reflects); T. Whitted, "An improved illumination model for shaded display", 1980 (rays).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WHITTED_OPTICS_H
#define PLT_WHITTED_OPTICS_H

#include "engine/base/float_bits.h"
#include "engine/base/vector.h"
#include "engine/lanes/unroll.h"

static inline float plt_optics_dot(const float a[3], const float b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* x^n by squaring, x in 0 .. 1: off by at most n 2^-23 of itself (each product rounds by 2^-24,
 * and what x^2k is off by doubles that of x^k), or 2^-126. */
static inline float plt_optics_power(float x, uint32_t n) {
    float product = 1.0f;
    for (; n > 0; n >>= 1) {
        product = (n & 1u) != 0 ? product * x : product;
        x = x * x;
    }
    return product;
}

/* e^-x for x from 0: off by at most 2^-21; 0 from 80 on. e^-x = 2^-k e^-r with r within half of
 * ln 2, of whose series seven terms are off by 2^-23 of it. */
static inline float plt_optics_fade(float x) {
    if (!(x < 80.0f)) {
        return 0.0f;
    }
    const int32_t k = (int32_t)(x * 1.44269504f + 0.5f);
    const float r = (float)k * 0.693147182f - x;
    float sum = 1.0f;
    for (int i = 6; i > 0; i--) {
        sum = 1.0f + sum * r / (float)i;
    }
    return sum * plt_float_of((uint32_t)(127 - k) << 23);
}

/* (1 - cosine)^5, by which a surface reflects more than it does face on. */
static inline float plt_optics_grazing(float cosine) {
    const float x = cosine < 1.0f ? 1.0f - cosine : 0.0f;
    return x * x * (x * x) * x;
}

/* Along d, off a surface with normal n against it; both of length 1. */
static inline void plt_optics_reflect(const float d[3], const float n[3], float to[3]) {
    const float twice = 2.0f * plt_optics_dot(d, n);
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        to[a] = d[a] - twice * n[a];
    }
    plt_normalise(to);
}

/* Through it, where light is 1 / `ratio` times as fast on the other side. Sets `cosine`, of the
 * angle there; 0: nothing passes (total reflection). */
static inline int plt_optics_refract(const float d[3], const float n[3], float ratio, float to[3],
                                     float *cosine) {
    const float along = -plt_optics_dot(d, n);
    const float squared = 1.0f - ratio * ratio * (1.0f - along * along);
    if (!(squared > 0.0f)) {
        return 0;
    }
    *cosine = __builtin_sqrtf(squared);
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        to[a] = ratio * d[a] + (ratio * along - *cosine) * n[a];
    }
    return plt_normalise(to);
}

/* What glass of that index reflects: `cosine` is that of the larger of both angles. */
static inline float plt_optics_glass(float index, float cosine) {
    const float root = (index - 1.0f) / (index + 1.0f), face_on = root * root;
    return face_on + (1.0f - face_on) * plt_optics_grazing(cosine);
}

#endif
