/* exact_rational - see exact_rational.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/exact_rational.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

exact_integer exact_of(float x, int unit) {
    exact_integer r = {0, 0, {0}};
    int exponent;
    const float fraction = frexpf(x, &exponent);
    uint64_t mantissa = (uint64_t)ldexpf(fabsf(fraction), 24);
    int shift = exponent - 24 - unit;
    for (; shift < 0 && mantissa % 2 == 0 && mantissa != 0; shift++) {
        mantissa /= 2;
    }
    if (mantissa == 0) {
        return r;
    }
    if (shift < 0 || shift > 32 * (EXACT_LIMBS - 2)) {
        abort();
    }
    const int at = shift / 32;
    mantissa <<= shift % 32;
    r.limb[at] = (uint32_t)mantissa;
    r.limb[at + 1] = (uint32_t)(mantissa >> 32);
    r.used = at + 1 + (r.limb[at + 1] != 0);
    r.sign = x < 0.0f ? -1 : 1;
    return r;
}

static void trim(exact_integer *a) {
    while (a->used > 0 && a->limb[a->used - 1] == 0) {
        a->used--;
    }
    a->sign = a->used == 0 ? 0 : a->sign;
}

static int compare_sizes(const exact_integer *a, const exact_integer *b) {
    if (a->used != b->used) {
        return a->used < b->used ? -1 : 1;
    }
    for (int i = a->used - 1; i >= 0; i--) {
        if (a->limb[i] != b->limb[i]) {
            return a->limb[i] < b->limb[i] ? -1 : 1;
        }
    }
    return 0;
}

/* |a| + |b|, or |a| - |b| with |a| >= |b|. */
static exact_integer combine(const exact_integer *a, const exact_integer *b, int subtract) {
    exact_integer r = {1, 0, {0}};
    const int used = a->used > b->used ? a->used : b->used;
    int64_t carry = 0;
    for (int i = 0; i < used || carry != 0; i++) {
        if (i == EXACT_LIMBS) {
            abort();
        }
        const int64_t other = (int64_t)b->limb[i];
        carry += (int64_t)a->limb[i] + (subtract ? -other : other);
        r.limb[i] = (uint32_t)carry;
        r.used = i + 1;
        carry = (carry - (int64_t)r.limb[i]) / 4294967296;
    }
    trim(&r);
    return r;
}

exact_integer exact_sum(const exact_integer *a, const exact_integer *b) {
    exact_integer r;
    if (a->sign * b->sign >= 0) {
        r = combine(a, b, 0);
        r.sign = r.used == 0 ? 0 : (a->sign != 0 ? a->sign : b->sign);
        return r;
    }
    const int larger = compare_sizes(a, b) >= 0;
    r = larger ? combine(a, b, 1) : combine(b, a, 1);
    r.sign = r.used == 0 ? 0 : (larger ? a->sign : b->sign);
    return r;
}

exact_integer exact_difference(const exact_integer *a, const exact_integer *b) {
    exact_integer minus = *b;
    minus.sign = -b->sign;
    return exact_sum(a, &minus);
}

exact_integer exact_product(const exact_integer *a, const exact_integer *b) {
    exact_integer r = {a->sign * b->sign, a->used + b->used, {0}};
    if (r.sign == 0) {
        r.used = 0;
        return r;
    }
    if (r.used > EXACT_LIMBS) {
        abort();
    }
    for (int i = 0; i < a->used; i++) {
        uint64_t carry = 0;
        for (int k = 0; k < b->used; k++) {
            carry += (uint64_t)a->limb[i] * b->limb[k] + r.limb[i + k];
            r.limb[i + k] = (uint32_t)carry;
            carry >>= 32;
        }
        r.limb[i + b->used] = (uint32_t)carry;
    }
    trim(&r);
    return r;
}

/* As a fraction and a power of two: no double overflows. */
static double fraction_of(const exact_integer *a, int *exponent) {
    double x = 0.0;
    for (int i = 1; i <= 3 && i <= a->used; i++) {
        x += ldexp((double)a->limb[a->used - i], -32 * i);
    }
    *exponent = 32 * a->used;
    return a->sign * x;
}

double exact_ratio(const exact_integer *a, const exact_integer *b) {
    int x, y;
    const double p = fraction_of(a, &x), q = fraction_of(b, &y);
    return ldexp(p / q, x - y);
}

/* ---- vectors ------------------------------------------------------------------------- */

typedef struct vector {
    exact_integer axis[3];
} vector;

static vector cross(const vector *a, const vector *b) {
    vector r;
    for (int x = 0; x < 3; x++) {
        const int y = (x + 1) % 3, z = (x + 2) % 3;
        const exact_integer p = exact_product(&a->axis[y], &b->axis[z]);
        const exact_integer q = exact_product(&a->axis[z], &b->axis[y]);
        r.axis[x] = exact_difference(&p, &q);
    }
    return r;
}

static exact_integer dot(const vector *a, const vector *b) {
    exact_integer r = {0, 0, {0}};
    for (int x = 0; x < 3; x++) {
        const exact_integer p = exact_product(&a->axis[x], &b->axis[x]);
        r = exact_sum(&r, &p);
    }
    return r;
}

static vector between(const float from[3], const float to[3], int unit) {
    vector r;
    for (int x = 0; x < 3; x++) {
        const exact_integer p = exact_of(to[x], unit), q = exact_of(from[x], unit);
        r.axis[x] = exact_difference(&p, &q);
    }
    return r;
}

/* A power of two that all three are multiples of, or the one given if that is less. */
static int unit_of(const float v[3], int unit) {
    for (int x = 0; x < 3; x++) {
        int exponent;
        if (frexpf(v[x], &exponent) != 0.0f) {
            unit = exponent - 24 < unit ? exponent - 24 : unit;
        }
    }
    return unit < -149 ? -149 : unit;
}

/* To length 1: from integers of any size. */
static void set_direction(double to[3], const vector *v) {
    int most = INT_MIN, exponent[3];
    for (int x = 0; x < 3; x++) {
        to[x] = fraction_of(&v->axis[x], &exponent[x]);
        most = to[x] != 0.0 && exponent[x] > most ? exponent[x] : most;
    }
    double length = 0.0;
    for (int x = 0; x < 3; x++) {
        to[x] = to[x] == 0.0 ? 0.0 : ldexp(to[x], exponent[x] - most);
        length += to[x] * to[x];
    }
    for (int x = 0; x < 3 && length > 0.0; x++) {
        to[x] /= sqrt(length);
    }
}

exact_answer exact_triangle(const float corner[3][3], const plt_ray *ray) {
    exact_answer r = {0, 0.0, 0.0, 0.0, 0.0, {0.0, 0.0, 0.0}};
    const float nothing[3] = {0.0f, 0.0f, 0.0f};
    int unit = unit_of(ray->org, INT_MAX), dir_unit = unit_of(ray->dir, INT_MAX);
    vector from[3];
    exact_integer weight[3];
    for (int c = 0; c < 3; c++) {
        unit = unit_of(corner[c], unit);
    }
    unit = unit == INT_MAX ? 0 : unit;
    dir_unit = dir_unit == INT_MAX ? 0 : dir_unit;
    for (int c = 0; c < 3; c++) {
        from[c] = between(ray->org, corner[c], unit);
    }
    const vector dir = between(nothing, ray->dir, dir_unit);
    int positive = 0, negative = 0;
    for (int c = 0; c < 3; c++) {
        const vector across = cross(&from[(c + 2) % 3], &from[(c + 1) % 3]);
        weight[c] = dot(&dir, &across);
        positive += weight[c].sign > 0;
        negative += weight[c].sign < 0;
    }
    const vector first = between(corner[0], corner[1], unit);
    const vector second = between(corner[0], corner[2], unit);
    const vector normal = cross(&first, &second);
    double toward[3];
    set_direction(r.normal, &normal);
    set_direction(toward, &dir);
    const exact_integer above = dot(&normal, &from[0]), along = dot(&normal, &dir);
    if (along.sign != 0) { /* in doubles it cancels, but not by more than the angle is worth */
        r.cosine =
            fabs(r.normal[0] * toward[0] + r.normal[1] * toward[1] + r.normal[2] * toward[2]);
    }
    r.meets = (positive == 0) != (negative == 0) && along.sign != 0;
    if (r.meets) {
        exact_integer sum = exact_sum(&weight[0], &weight[1]);
        sum = exact_sum(&sum, &weight[2]);
        r.t = ldexp(exact_ratio(&above, &along), unit - dir_unit);
        r.u = exact_ratio(&weight[1], &sum);
        r.v = exact_ratio(&weight[2], &sum);
    }
    return r;
}
