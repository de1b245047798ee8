/* mesh - triangles with shared vertices, as read from files
 *
 * Invariant of every mesh that a reader returned: all vertices are finite
 * and within +-PLT_COORD_MAX, all indices are below `vertices`.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MESH_H
#define MESH_H
#include <stddef.h>
#include <stdint.h>

#include "host_tools/base/fail.h"
#include "host_tools/mesh/corners.h"
#include "host_tools/mesh/materials.h"
#include "host_tools/mesh/real.h"
#include "host_tools/mesh/report.h"

typedef struct mesh {
    float *vertex;      /* 3 floats per vertex: x y z */
    double *wide;       /* the same before they became floats; NULL: the floats are exact */
    uint32_t *triangle; /* 3 vertex indices per triangle */
    size_t vertices, triangles;
    size_t vertex_room, triangle_room; /* allocated, in vertices, triangles */
    mesh_materials *materials;         /* for readers; NULL: nobody wants them */
    mesh_corners *corners; /* normals and colours, for readers; NULL: nobody wants them */
} mesh;

/* Appends what `path` holds (PLY, OBJ or STL by content, then by name; a
 * `.txt` is a recipe) to `m`. `frame` is the frame to read of a
 * recipe's sequences (`name_{}.ply*N`). The path "-" is standard input, by content
 * only. Triangles stand in the order of the file, those of a polygon as its outline
 * demands; degenerate ones are kept. `report` is added to. On failure `m` and the
 * report are as they were before. */
int mesh_read(mesh *m, const char *path, unsigned frame, mesh_report *report, fail *f);

/* For readers and generators: -1 when memory is out. */
int mesh_add_vertex(mesh *m, float x, float y, float z, fail *f);
int mesh_add_real(mesh *m, const real position[3], fail *f);
int mesh_add_triangle(mesh *m, uint32_t a, uint32_t b, uint32_t c, fail *f);
/* From now on there are wide coordinates: of the vertices so far, the floats. */
int mesh_widen(mesh *m, fail *f);
/* Makes room for that many more: adding them then cannot fail, but for the first vertex
 * that is not exact in single precision. */
int mesh_reserve(mesh *m, size_t vertices, size_t triangles, fail *f);
/* Gives back what growing took in advance. */
void mesh_fit(mesh *m);
void mesh_free(mesh *m);

/* A coordinate as the file has it. */
static inline double mesh_wide(const mesh *m, size_t vertex, int axis) {
    const size_t at = 3 * vertex + (size_t)axis;
    return m->wide != NULL ? m->wide[at] : (double)m->vertex[at];
}

/* Vertices that some triangles use, from the first to the last: those of one file lie together. */
typedef struct vertex_range {
    size_t first, count;
} vertex_range;

vertex_range mesh_vertices_of(const mesh *m, size_t first, size_t end);

/* Writes binary little-endian PLY, float x y z and uchar/int lists. */
int mesh_write_ply(const mesh *m, const char *path, fail *f);

#endif
