/* placement - turns, scales and moves a mesh onto its place in a scene
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLACEMENT_H
#define PLACEMENT_H
#include "host_tools/mesh/mesh.h"

/* In this order: turn about x, turn about y, scale so that the longest side
 * of the bounding box is `size`, move so that the centre of the box's base
 * (its middle in x and z, its least y) is `base`. */
typedef struct placement {
    float size; /* > 0 */
    float base[3];
    float turn_x, turn_y; /* degrees */
} placement;

/* Places the vertices from `first_vertex` on; the box is that of the
 * triangles from `first_triangle` on. Fails, with the mesh undefined, when
 * the box has no extent or a vertex leaves +-PLT_COORD_MAX. */
int placement_apply(const placement *p, mesh *m, size_t first_vertex, size_t first_triangle,
                    const char *path, fail *f);

#endif
