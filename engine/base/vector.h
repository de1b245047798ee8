/* vector - three floats: products, and vectors of any size made as long as 1
 *
 * Single precision in this order, and no contraction: the same bits on every machine.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BASE_VECTOR_H
#define PLT_BASE_VECTOR_H

static inline float plt_dot(const float a[3], const float b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void plt_cross(const float a[3], const float b[3], float to[3]) {
    to[0] = a[1] * b[2] - a[2] * b[1];
    to[1] = a[2] * b[0] - a[0] * b[2];
    to[2] = a[0] * b[1] - a[1] * b[0];
}

static inline float plt_largest(const float v[3]) {
    const float x = __builtin_fabsf(v[0]), y = __builtin_fabsf(v[1]), z = __builtin_fabsf(v[2]);
    const float most = x > y ? x : y;
    return most > z ? most : z;
}

/* Divides by the largest component, so that no square vanishes or overflows, and returns it. 0 has
 * no direction, and stays. */
static inline float plt_even_out(float v[3]) {
    const float most = plt_largest(v);
    if (most > 0.0f) {
        v[0] /= most;
        v[1] /= most;
        v[2] /= most;
    }
    return most;
}

/* Makes a vector as long as 1, up to 2^-22 or so, however long it was; 0: it has no direction, and
 * stays. */
static inline int plt_normalise(float v[3]) {
    if (!(plt_even_out(v) > 0.0f)) {
        return 0;
    }
    const float length = __builtin_sqrtf(plt_dot(v, v));
    v[0] /= length;
    v[1] /= length;
    v[2] /= length;
    return 1;
}

#endif
