/* surface_triangles - where an image's triangles are, as the engine sees them
 *
 * SPDX-License-Identifier: MIT */
#ifndef SURFACE_TRIANGLES_H
#define SURFACE_TRIANGLES_H
#include "host_tools/pack/pack.h"

/* A triangle of an image: its primitive id, and the keys of its corners (surface_corners.h) in the
 * order of the packed mesh. */
typedef struct surface_triangle {
    uint32_t id;
    uint32_t key[3][3];
} surface_triangle;

/* All of a finished image, in its order; `to` has room for its info's triangles. */
void surface_triangles_read(surface_triangle *to, const packed *image);

#endif
