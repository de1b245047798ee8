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

/* Leaves at most `most` (1 or more) triangles; a mesh that has no more is not
 * changed. */
int mesh_reduce(mesh *m, size_t most, const char *name, fail *f);

#endif
