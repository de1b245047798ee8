/* exact - see exact.h
 *
 * In pairs: with P = p - org and E = q - p (both exact as pairs) the wanted value is
 * dir . (P x E). Each product of pairs is off by at most 2^-46 of itself, each
 * sum of pairs by 2^-44 of its operands; all of them together, 2^-42 of the
 * sum of the magnitudes, are less than the bound used.
 *
 * P and E are brought to a size of about 1 and dir to the same by powers of
 * two, which changes no sign and keeps clear of overflow; parts that underflow
 * then are below 2^-100 in all, which the bound covers.
 *
 * In integers nothing is scaled and nothing lost: a determinant of pairs is a sum of at most
 * 48 products of three floats.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/exact.h"

#include <stdint.h>
#include <string.h>

#define ERROR 2.2737367544323206e-13f    /* 2^-42 */
#define UNDERFLOW 7.888609052210118e-31f /* 2^-100 */

typedef struct pair {
    float high, low; /* value = high + low, |low| <= 2^-24 |high| */
} pair;

static float absolute(float x) {
    return __builtin_fabsf(x);
}

float plt_power_to_one(const float v[3]) {
    const float x = absolute(v[0]), y = absolute(v[1]), z = absolute(v[2]);
    const float xy = x > y ? x : y, most = xy > z ? xy : z;
    uint32_t bits;
    float p;
    memcpy(&bits, &most, sizeof bits);
    const uint32_t exponent = bits >> 23 & 0xFF;
    bits = (exponent == 0 ? 253u : 254u - exponent) << 23;
    memcpy(&p, &bits, sizeof p);
    return p;
}

static pair sum(float a, float b) {
    const float s = a + b, b1 = s - a, a1 = s - b1;
    const pair r = {s, (a - a1) + (b - b1)};
    return r;
}

static pair product(float a, float b) {
    const float split = 4097.0f; /* 2^12 + 1 */
    const float ta = split * a, tb = split * b;
    const float ah = ta - (ta - a), bh = tb - (tb - b);
    const float al = a - ah, bl = b - bh;
    const float p = a * b;
    const pair r = {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
    return r;
}

static pair pair_sum(pair a, pair b) {
    const pair h = sum(a.high, b.high), l = sum(a.low, b.low);
    const pair m = sum(h.high, h.low + l.high);
    return sum(m.high, m.low + l.low);
}

static pair pair_product(pair a, pair b) {
    const pair p = product(a.high, b.high);
    return sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

static pair scaled(pair a, float power) {
    const pair r = {a.high * power, a.low * power};
    return r;
}

static pair negative(pair a) {
    const pair r = {-a.high, -a.low};
    return r;
}

int plt_edge_side(const float p[3], const float q[3], const float org[3], const float dir[3]) {
    pair from[3], edge[3];
    float reach[3], length[3], value_size = 0.0f;
    for (int a = 0; a < 3; a++) {
        from[a] = sum(p[a], -org[a]);
        edge[a] = sum(q[a], -p[a]);
        reach[a] = from[a].high;
        length[a] = edge[a].high;
    }
    const float by_reach = plt_power_to_one(reach), by_length = plt_power_to_one(length);
    const float by_dir = plt_power_to_one(dir);
    for (int a = 0; a < 3; a++) {
        from[a] = scaled(from[a], by_reach);
        edge[a] = scaled(edge[a], by_length);
    }
    pair value = {0.0f, 0.0f};
    for (int a = 0; a < 3; a++) {
        const int b = a < 2 ? a + 1 : 0, c = b < 2 ? b + 1 : 0;
        const pair d = {dir[a] * by_dir, 0.0f};
        const pair plus = pair_product(from[b], edge[c]), minus = pair_product(from[c], edge[b]);
        value = pair_sum(value, pair_product(pair_sum(plus, negative(minus)), d));
        value_size += absolute(d.high) * (absolute(plus.high) + absolute(minus.high));
    }
    const float error = ERROR * value_size + UNDERFLOW;
    return value.high > error ? 1 : (value.high < -error ? -1 : 0);
}

/* A vector of pairs: all high parts, then all low parts. */
typedef float pair_vector[2][3];

/* a . (b x c) */
static plt_scaled volume(const pair_vector a, const pair_vector b, const pair_vector c) {
    plt_wide value = {{0}};
    for (unsigned x = 0; x < 3; x++) {
        const unsigned y = x < 2 ? x + 1 : 0, z = y < 2 ? y + 1 : 0;
        for (unsigned i = 0; i < 8; i++) {
            const float *p = a[i & 1u], *q = b[i >> 1 & 1u], *r = c[i >> 2];
            plt_wide_add(&value, p[x], q[y], r[z]);
            plt_wide_add(&value, -p[x], q[z], r[y]);
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

static void set_single(pair_vector to, const float from[3]) {
    memcpy(to[0], from, sizeof to[0]);
    memset(to[1], 0, sizeof to[1]);
}

plt_scaled plt_edge_value(const float p[3], const float q[3], const float org[3],
                          const float dir[3]) {
    pair_vector from, edge, along;
    set_difference(from, p, org);
    set_difference(edge, q, p);
    set_single(along, dir);
    return volume(along, from, edge);
}

float plt_exact_distance(const float corner[3][3], const float org[3], const float dir[3]) {
    pair_vector from, first, second;
    set_difference(first, corner[1], corner[0]);
    set_difference(second, corner[2], corner[0]);
    set_difference(from, corner[0], org);
    plt_scaled t = volume(from, first, second);
    set_single(from, dir);
    const plt_scaled along = volume(from, first, second);
    if (along.mantissa == 0.0f) {
        return 0.0f;
    }
    t.mantissa /= along.mantissa;
    t.exponent -= along.exponent;
    return plt_scaled_float(t, 0);
}
