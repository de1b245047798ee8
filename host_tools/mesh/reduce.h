/* reduce - fewer triangles, by vertex clustering
 *
 * Vertices that share a cell of a uniform grid become one at their mean; triangles
 * with two corners in one cell are dropped. Bisection finds the finest grid that
 * leaves no more triangles than wanted.
 *
 * Source: Rossignac and Borrel, "Multi-resolution 3D approximations for
 * rendering complex scenes", 1993.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MESH_REDUCE_H
#define MESH_REDUCE_H
#include "host_tools/mesh/mesh.h"

/* Leaves 1 to `most` triangles; a mesh that has no more is not changed. Only triangles that
 * count (extent.h) and their vertices are looked at. Where nothing would be left it fails,
 * and says how many triangles it can leave; the mesh is then as it was. */
int mesh_reduce(mesh *m, size_t most, const char *name, fail *f);

/* The most bytes it takes beside a mesh of so many vertices. */
uint64_t mesh_reduce_bytes(uint64_t vertices, uint64_t most);

#endif
