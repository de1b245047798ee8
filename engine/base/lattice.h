/* lattice - the scene's quantisation grid: whole coordinates of boxes and vertices
 *
 * Coordinate q on an axis is the float origin + step * q. q has at most `bits` bits
 * and step at most 24 - bits bits of mantissa: the product is exact and the sum rounds
 * once. That is the same with or without fused arithmetic, and monotone: an integer box
 * around integer vertices is a float box around their floats.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BASE_LATTICE_H
#define PLT_BASE_LATTICE_H

#include <stdint.h>

#include "engine/base/box.h"

#define PLT_LATTICE_BITS_LEAST 12
#define PLT_LATTICE_BITS_MOST 21

typedef struct plt_lattice {
    float origin[4]; /* x y z; the fourth is 0, for 4-lane operations */
    float step;
    uint32_t bits; /* 12 .. 21 */
} plt_lattice;

typedef struct plt_lattice_box {
    uint32_t lo[3], hi[3];
} plt_lattice_box;

/* A position in one word, which orders as x, then y, then z. */
static inline uint64_t plt_lattice_key(const uint32_t position[3]) {
    return (uint64_t)position[0] << 42 | (uint64_t)position[1] << 21 | position[2];
}

static inline float plt_lattice_float(const plt_lattice *l, int axis, uint32_t q) {
    return l->origin[axis] + l->step * (float)(int32_t)q;
}

static inline void plt_lattice_to_box(const plt_lattice *l, const plt_lattice_box *from,
                                      plt_box *to) {
    for (int a = 0; a < 3; a++) {
        to->lo[a] = plt_lattice_float(l, a, from->lo[a]);
        to->hi[a] = plt_lattice_float(l, a, from->hi[a]);
    }
}

/* The coordinates as floats, which hold them exactly; the fourth is 0. */
static inline void plt_lattice_spread(const plt_lattice_box *from, float lo[4], float hi[4]) {
    for (int a = 0; a < 3; a++) {
        lo[a] = (float)(int32_t)from->lo[a];
        hi[a] = (float)(int32_t)from->hi[a];
    }
    lo[3] = hi[3] = 0.0f;
}

#endif
