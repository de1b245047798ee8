/* extent - which triangles count, and how far they reach
 *
 * A triangle that has no area is never hit. It may gain one when vertices move, and then
 * closes what it closed in the mesh; so it counts where it lies within the box of the
 * triangles that have an area, but it never widens that box. One with two corners at one
 * position gains none and never counts, and nor does a vertex that no triangle uses.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MESH_EXTENT_H
#define MESH_EXTENT_H
#include "engine/base/box.h"
#include "host_tools/mesh/mesh.h"

/* Has an area, computed in double. */
int mesh_has_area(const mesh *m, size_t triangle);

/* The box of the corners of all triangles, or of those that have an area; empty (box.h)
 * when there are none. */
plt_box mesh_box(const mesh *m);
plt_box mesh_area_box(const mesh *m);

/* Whether a triangle counts; `box` is mesh_area_box. */
int mesh_counts(const mesh *m, const plt_box *box, size_t triangle);

#endif
