/* exact - see exact.h
 *
 * Differences of floats are exact as pairs of floats, so a determinant of three differences
 * is a sum of at most 48 products of three floats.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/exact.h"

#include <stdint.h>

#include "engine/base/float_bits.h"

typedef struct pair {
    float high, low; /* value = high + low, |low| <= 2^-24 |high| */
} pair;

static float absolute(float x) {
    return __builtin_fabsf(x);
}

float plt_power_to_one(const float v[3]) {
    const float x = absolute(v[0]), y = absolute(v[1]), z = absolute(v[2]);
    const float xy = x > y ? x : y, most = xy > z ? xy : z;
    const uint32_t exponent = plt_bits_of(most) >> 23 & 0xFF;
    return plt_float_of((exponent == 0 ? 253u : 254u - exponent) << 23);
}

static pair sum(float a, float b) {
    const float s = a + b, b1 = s - a, a1 = s - b1;
    const pair r = {s, (a - a1) + (b - b1)};
    return r;
}

/* A vector of pairs: all high parts, then all low parts. */
typedef float pair_vector[2][3];

/* The low parts of a vector of floats. */
static const float no_low[3];

/* (high + low) . (b x c) */
static plt_scaled volume(const float high[3], const float low[3], const pair_vector b,
                         const pair_vector c) {
    plt_wide value = {{0}};
    for (unsigned x = 0; x < 3; x++) {
        const unsigned y = x < 2 ? x + 1 : 0, z = y < 2 ? y + 1 : 0;
        for (unsigned i = 0; i < 8; i++) {
            const float p = i < 4 ? high[x] : low[x], *q = b[i >> 1 & 1u], *r = c[i & 1u];
            plt_wide_add(&value, p, q[y], r[z]);
            plt_wide_add(&value, -p, q[z], r[y]);
        }
    }
    return plt_wide_value(&value);
}

static void set_difference(pair_vector to, const float p[3], const float q[3]) {
    for (int a = 0; a < 3; a++) {
        const pair difference = sum(p[a], -q[a]);
        to[0][a] = difference.high;
        to[1][a] = difference.low;
    }
}

plt_scaled plt_edge_value(const float p[3], const float q[3], const float org[3],
                          const float dir[3]) {
    pair_vector from, edge;
    set_difference(from, p, org);
    set_difference(edge, q, p);
    return volume(dir, no_low, from, edge);
}

float plt_exact_distance(const float corner[3][3], const float org[3], const float dir[3]) {
    pair_vector from, first, second;
    set_difference(first, corner[1], corner[0]);
    set_difference(second, corner[2], corner[0]);
    set_difference(from, corner[0], org);
    plt_scaled t = volume(from[0], from[1], first, second);
    const plt_scaled along = volume(dir, no_low, first, second);
    if (along.mantissa == 0.0f) {
        return 0.0f;
    }
    t.mantissa /= along.mantissa;
    t.exponent -= along.exponent;
    return plt_scaled_float(t, 0);
}
