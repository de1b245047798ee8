/* between - a mesh on its way from one pose to another
 *
 * SPDX-License-Identifier: MIT */
#ifndef BETWEEN_H
#define BETWEEN_H
#include "host_tools/mesh/mesh.h"

/* The first triangle that has other vertices in `b` than in `a`, or SIZE_MAX: they are the same,
 * and so are the numbers of vertices and triangles; 0 if not those. */
size_t between_differs(const mesh *a, const mesh *b);

/* Makes `m`, which is all 0, the mesh `a` with each vertex `part` of `whole` of the straight way to
 * where it is in `b`, of the same triangles; at both ends, and where both are equal, it is exactly
 * that. part <= whole < 2^20, whole > 0. */
int between_make(mesh *m, const mesh *a, const mesh *b, unsigned part, unsigned whole, fail *f);

#endif
