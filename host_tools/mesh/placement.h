/* placement - rotates, scales and moves a mesh to its position in a scene
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLACEMENT_H
#define PLACEMENT_H
#include "host_tools/mesh/mesh.h"

/* In this order: rotate about x, rotate about y, scale until the longest side
 * of the bounding box is `size`, move until the centre of the box's base (its
 * middle in x and z, its least y) is at `base`. */
typedef struct placement {
    float size; /* > 0 */
    float base[3];
    float angle_x, angle_y; /* degrees */
} placement;

/* Places the vertices from `first_vertex` on; the box is that of the
 * triangles from `first_triangle` on. With `wide` the coordinates before they became floats
 * are placed, and are then kept beside the floats. Fails, and leaves the mesh undefined, when
 * there are no triangles, their box has no extent or a vertex leaves +-PLT_COORD_MAX. */
int placement_apply(const placement *p, mesh *m, size_t first_vertex, size_t first_triangle,
                    int wide, const char *path, fail *f);

#endif
