/* intake_corners - normals, colours and texture coordinates of a file, until its triangles are
 * known
 *
 * Readers hand them in as the file has them: normals and texture coordinates by vertex, or numbered
 * for themselves and named by corners; colours by vertex.
 *
 * SPDX-License-Identifier: MIT */
#ifndef INTAKE_CORNERS_H
#define INTAKE_CORNERS_H
#include "host_tools/mesh/corners.h"
#include "host_tools/mesh/faces.h"

typedef struct corner_list {
    uint32_t *item; /* owned */
    size_t count, room;
} corner_list;

typedef struct intake_corners {
    corner_list normal;      /* as mesh_corners has them */
    corner_list texcoord[2]; /* likewise, u and v, as many of both */
    corner_list colour;      /* by vertex of the file; CORNER_NO_COLOUR for those that have none */
    corner_list named[CORNER_NAMES]; /* by corner of the file's triangles, in their order: a number
                                      * in `normal` or `texcoord`, or CORNER_UNNAMED. Empty: they
                                      * are by vertex, unless ... */
    uint8_t
        is_numbered[CORNER_NAMES]; /* ... they have numbers of their own, which no corner names */
} intake_corners;

#define CORNER_UNNAMED UINT32_MAX

/* Each -1 when memory is out. Puts an item at `at`; those between are `none`. */
int corner_list_put(corner_list *l, size_t at, uint32_t item, uint32_t none);

/* Gives the triangles from `first_triangle` on, whose vertices are numbers of the mesh, what was
 * handed in. */
int intake_corners_finish(const intake_corners *in, mesh *m, size_t first_vertex,
                          size_t first_triangle);
void intake_corners_free(intake_corners *in);

#endif
