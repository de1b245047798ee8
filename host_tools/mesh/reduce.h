/* reduce - fewer triangles, by vertex clustering
 *
 * Vertices that share a cell of a uniform grid become one, their mean; triangles
 * that lose a corner go. The finest grid that leaves no more than the wanted
 * number is found by bisection.
 *
 * Source: Rossignac and Borrel, "Multi-resolution 3D approximations for
 * rendering complex scenes", 1993.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MESH_REDUCE_H
#define MESH_REDUCE_H
#include "host_tools/mesh/mesh.h"

/* Leaves at most `most` (1 or more) triangles; a mesh that has no more stays as
 * it is. */
int mesh_reduce(mesh *m, size_t most, const char *name, fail *f);

#endif
