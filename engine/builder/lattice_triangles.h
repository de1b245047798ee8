/* lattice_triangles - what compact blocks are built from: triangles on the lattice
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BUILDER_LATTICE_TRIANGLES_H
#define PLT_BUILDER_LATTICE_TRIANGLES_H

#include <stddef.h>
#include <stdint.h>

#include "engine/base/bytes.h"
#include "engine/base/lattice.h"
#include "engine/image/record_cache.h"

/* Corners of triangles on the lattice, the scene's quantisation grid: 9 coordinates
 * each, of plt_corner_width bytes, little-endian. Or, where the geometry stays in float
 * records, their boxes, rounded outwards: low x y z, high x y z. */
typedef struct plt_lattice_triangles {
    const unsigned char *bytes;
    uint32_t count;
    uint32_t width;          /* 2 or 4 */
    uint32_t boxes;          /* 1: boxes of 6 coordinates; 0: corners */
    plt_record_cache *cache; /* reads them, if not NULL; then `bytes` are not read */
} plt_lattice_triangles;

/* The coordinates of a triangle; valid until the next call. */
static inline const unsigned char *plt_lattice_triangle(const plt_lattice_triangles *t,
                                                        uint32_t triangle) {
    const size_t each = t->boxes ? 6 : 9;
    return t->cache != NULL ? plt_record_cache_find(t->cache, triangle)
                            : t->bytes + each * triangle * t->width;
}

static inline uint32_t plt_lattice_coordinate(const plt_lattice_triangles *t,
                                              const unsigned char *triangle, uint32_t k) {
    const unsigned char *at = triangle + k * t->width;
    return t->width == 2 ? (uint32_t)(at[0] | at[1] << 8) : plt_get_u32(at);
}

static inline void plt_lattice_corners(const plt_lattice_triangles *t, uint32_t triangle,
                                       uint32_t corner[3][3]) {
    const unsigned char *at = plt_lattice_triangle(t, triangle);
    for (uint32_t k = 0; k < 9; k++) {
        corner[k / 3][k % 3] = plt_lattice_coordinate(t, at, k);
    }
}

static inline plt_lattice_box plt_lattice_box_empty(void) {
    const plt_lattice_box b = {{0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu}, {0, 0, 0}};
    return b;
}

static inline void plt_lattice_box_add(plt_lattice_box *b, const plt_lattice_box *c) {
    for (int a = 0; a < 3; a++) {
        b->lo[a] = c->lo[a] < b->lo[a] ? c->lo[a] : b->lo[a];
        b->hi[a] = c->hi[a] > b->hi[a] ? c->hi[a] : b->hi[a];
    }
}

/* Twice the centre of its box on an axis. */
static inline uint32_t plt_lattice_triangle_centre2(const plt_lattice_triangles *t,
                                                    uint32_t triangle, uint32_t axis) {
    const unsigned char *at = plt_lattice_triangle(t, triangle);
    const uint32_t x = plt_lattice_coordinate(t, at, axis),
                   y = plt_lattice_coordinate(t, at, 3 + axis),
                   z = plt_lattice_coordinate(t, at, t->boxes ? 3 + axis : 6 + axis);
    const uint32_t lo = x < y ? x : y, hi = x < y ? y : x;
    return (z < lo ? z : lo) + (z > hi ? z : hi);
}

static inline plt_lattice_box plt_lattice_triangle_box(const plt_lattice_triangles *t,
                                                       uint32_t triangle) {
    const unsigned char *at = plt_lattice_triangle(t, triangle);
    const uint32_t step = 3 * t->width, last = t->boxes ? 3 : 6; /* of nine coordinates, or six */
    plt_lattice_box b;
    for (uint32_t a = 0; a < 3; a++) {
        const uint32_t x = plt_lattice_coordinate(t, at, a),
                       z = plt_lattice_coordinate(t, at, last + a);
        const uint32_t y = plt_lattice_coordinate(t, at + step, a);
        const uint32_t lo = x < y ? x : y, hi = x < y ? y : x;
        b.lo[a] = z < lo ? z : lo;
        b.hi[a] = z > hi ? z : hi;
    }
    return b;
}

#endif
