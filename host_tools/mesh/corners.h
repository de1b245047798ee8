/* corners - normals, colours and texture coordinates of the corners of a mesh's triangles
 *
 * Kept apart from the mesh, by triangle and corner: whoever wants them hangs one on `mesh.corners`
 * before files are read.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MESH_CORNERS_H
#define MESH_CORNERS_H
#include <stddef.h>
#include <stdint.h>

/* A direction in 32 bits, 16 for each axis of an octahedron's square (engine/surface/octahedral.h
 * has 8): off by less than 0.002 degrees. */
#define CORNER_NO_NORMAL 0x80008000u
/* Red in bits 0 to 7, green, blue, and 255 above them; 0: the corner has no colour. */
#define CORNER_NO_COLOUR 0u
/* The bits of a float; this one, which is not a number: the corner has no texture coordinates. */
#define CORNER_NO_TEXCOORD 0x7FC00000u
/* They are within this, either way: textures repeat. */
#define CORNER_TEXCOORD_MOST 65536.0

typedef struct mesh_corners {
    int wants_normals, wants_colours, wants_texcoords; /* of files */
    uint32_t *normal;                     /* 3 per triangle; owned, NULL: there are none */
    uint32_t *colour;                     /* likewise */
    uint32_t *texcoord[2];                /* likewise: u and v; either both are there or none */
    int has_fine_texcoords;               /* asked for: in an image they take 32 bits, not 24 */
    size_t triangles;                     /* that there is room for, in those that are there */
    uint64_t normals, colours, texcoords; /* of files: corners that have one */
} mesh_corners;

/* `n` is finite and has a length; of any length. */
uint32_t corner_normal(const double n[3]);
/* Of length 1. CORNER_NO_NORMAL is none. */
void corner_direction(uint32_t normal, double n[3]);

static inline uint32_t corner_colour(uint32_t red, uint32_t green, uint32_t blue) {
    return red | green << 8 | blue << 16 | 0xFF000000u;
}

/* One of the two, within CORNER_TEXCOORD_MOST. */
uint32_t corner_texcoord(double coordinate);

/* Makes room for normals, for colours, or for texture coordinates, of so many triangles, none of
 * which has any yet; -1 when memory is out. */
int corners_want_normals(mesh_corners *c, size_t triangles);
int corners_want_colours(mesh_corners *c, size_t triangles);
int corners_want_texcoords(mesh_corners *c, size_t triangles);
void corners_free(mesh_corners *c);

#endif
