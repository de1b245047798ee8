/* smooth - normals of corners, from the triangles that meet there
 *
 * SPDX-License-Identifier: MIT */
#ifndef MESH_SMOOTH_H
#define MESH_SMOOTH_H
#include "host_tools/mesh/corners.h"
#include "host_tools/mesh/mesh.h"

/* The normal of a corner is the sum of those of all triangles that meet in its position and lie at
 * no more than `degrees`, 0 to 180, to its own, each weighted by its angle there (G. Thuermer and
 * C. A. Wuethrich, Computing Vertex Normals from Polygonal Facets, 1998). Corners of triangles
 * without area, and sums that cancel out, have the triangle's own, or none. -1: memory is out. */
int mesh_smooth(const mesh *m, double degrees, mesh_corners *c);

#endif
