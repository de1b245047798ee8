/* ray_order - see ray_order.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/ray_order.h"

#include <math.h>
#include <stdlib.h>

/* Bits of a cell along an axis, and of a direction along an edge of a face. */
enum { CELL_BITS = 10, FACE_BITS = 7 };

typedef struct named_key {
    uint64_t key;
    uint32_t index;
} named_key;

typedef struct span {
    float lo, hi;
} span;

/* Of what is finite; lo > hi when nothing is. */
static span span_of(const plt_ray *rays, uint32_t count, int axis) {
    span s = {INFINITY, -INFINITY};
    for (uint32_t i = 0; i < count; i++) {
        const float at = rays[i].org[axis];
        s.lo = isfinite(at) && at < s.lo ? at : s.lo;
        s.hi = isfinite(at) && at > s.hi ? at : s.hi;
    }
    return s;
}

/* 0 .. 2^bits - 1, where `at` lies between lo and hi; what lies nowhere is 0. */
static uint64_t step_of(double at, double lo, double hi, int bits) {
    const double most = (double)((1u << bits) - 1u), where = (at - lo) / (hi - lo) * most;
    return where > 0.0 ? (uint64_t)(where < most ? where : most) : 0;
}

/* Bit i of each of `count` numbers becomes one of `count` neighbours. */
static uint64_t interleave(const uint64_t *number, int count, int bits) {
    uint64_t curve = 0;
    for (int bit = bits; bit-- > 0;) {
        for (int i = 0; i < count; i++) {
            curve = curve << 1 | (number[i] >> bit & 1u);
        }
    }
    return curve;
}

static uint64_t cell_of(const plt_ray *ray, const span axis[3]) {
    uint64_t step[3];
    for (int a = 0; a < 3; a++) {
        step[a] = step_of(ray->org[a], axis[a].lo, axis[a].hi, CELL_BITS);
    }
    return interleave(step, 3, CELL_BITS);
}

/* The face, and where on it. */
static uint64_t direction_of(const plt_ray *ray) {
    const float *d = ray->dir;
    int axis = 0;
    uint64_t step[2];
    for (int a = 1; a < 3; a++) {
        axis = fabsf(d[a]) > fabsf(d[axis]) ? a : axis;
    }
    for (int i = 0; i < 2; i++) {
        const double largest = fabs((double)d[axis]);
        step[i] = step_of(d[(axis + 1 + i) % 3], -largest, largest, FACE_BITS);
    }
    const uint64_t face = 2 * (uint64_t)axis + (d[axis] < 0.0f);
    return face << 2 * FACE_BITS | interleave(step, 2, FACE_BITS);
}

static int compare(const void *one, const void *other) {
    const named_key *a = one, *b = other;
    if (a->key != b->key) {
        return a->key < b->key ? -1 : 1;
    }
    return a->index < b->index ? -1 : a->index > b->index;
}

int ray_order_sort(const plt_ray *rays, uint32_t count, uint32_t *order) {
    const span axis[3] = {span_of(rays, count, 0), span_of(rays, count, 1),
                          span_of(rays, count, 2)};
    named_key *keys = malloc((size_t)count * sizeof *keys + 1);
    if (keys == NULL) {
        return -1;
    }
    for (uint32_t i = 0; i < count; i++) {
        keys[i].key = cell_of(&rays[i], axis) << (2 * FACE_BITS + 3) | direction_of(&rays[i]);
        keys[i].index = i;
    }
    qsort(keys, count, sizeof *keys, compare);
    for (uint32_t i = 0; i < count; i++) {
        order[i] = keys[i].index;
    }
    free(keys);
    return 0;
}
