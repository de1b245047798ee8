/* shapes - small meshes for tests
 *
 * Each appends to `m`; running out of memory ends the program. Closed shapes have every edge
 * twice, once in each direction, and `inside` points.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_SHAPES_H
#define REFERENCE_SHAPES_H

#include "host_tools/mesh/mesh.h"
#include "tests/reference/random.h"

/* `triangles` triangles of edge about `size` in the cube -1 .. 1. */
void shape_soup(mesh *m, uint32_t triangles, float size, uint64_t seed);

/* side * side squares of two triangles in the plane `axis` = 0. */
void shape_sheet(mesh *m, uint32_t side, int axis);

/* Closed: the cube -1 .. 1; 20 * 4^levels triangles of a unit sphere about
 * the origin; a double pyramid of `sides` needles, a thousandth as wide as long. */
void shape_cube(mesh *m);
void shape_icosphere(mesh *m, unsigned levels);
void shape_needles(mesh *m, uint32_t sides);

/* `copies` times the same triangle, then a second one twice. */
void shape_coincident(mesh *m, uint32_t copies);

/* Points, lines, repeated corners among a few proper triangles. */
void shape_degenerate(mesh *m);

/* Triangle i is at 2^-i and of that size, as far as floats go. */
void shape_exponential(mesh *m, uint32_t triangles);

/* A copy of all vertices and triangles. */
mesh shape_copy(const mesh *m);

/* Multiplies, then moves, every vertex. */
void shape_transform(mesh *m, float scale, float x, float y, float z);

/* The box of all vertices. */
void shape_box(const mesh *m, float lo[3], float hi[3]);

/* Corner `corner` of triangle `triangle`. */
static inline const float *shape_corner(const mesh *m, uint32_t triangle, unsigned corner) {
    return m->vertex + 3 * (size_t)m->triangle[3 * (size_t)triangle + corner];
}

#endif
