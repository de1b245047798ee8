/* faces - from the file's vertex indices to triangles of the mesh
 *
 * While a file is read, its triangles hold the file's own vertex indices, and a face of more
 * corners is a fan of triangles. When all vertices are known, faces become triangles of the
 * mesh, as their outlines demand.
 *
 * SPDX-License-Identifier: MIT */
#ifndef FACES_H
#define FACES_H
#include "host_tools/mesh/mesh.h"

/* What corners name by numbers of their own. */
enum { NAMED_NORMAL, NAMED_TEXCOORD, CORNER_NAMES };

/* A face of more than three corners: its fan begins with triangle `first`. */
typedef struct face_fan {
    size_t first;
    uint32_t corners;
} face_fan;

typedef struct mesh_faces {
    size_t first_vertex, first_triangle; /* of the file, in the mesh */
    unsigned char *bad;                  /* one bit per vertex of the file; owned */
    size_t bad_bytes;
    face_fan *fan; /* in the order of the file; owned */
    size_t fans, room;
    uint32_t *named[CORNER_NAMES]; /* 3 per triangle of the file, which go where their corners go;
                                    * NULL: none */
} mesh_faces;

/* Each returns -1 when memory is out. */
int faces_add_fan(mesh_faces *f, size_t first, uint32_t corners);
int faces_mark_bad(mesh_faces *f, size_t vertex);

/* Triangulates the fans' outlines, drops faces with a corner that is bad or missing, and
 * makes the rest name vertices of the mesh. Triangles keep the order of the file. Counts
 * REPORT_BAD_FACES and REPORT_OVERLAPPING. */
int faces_resolve(const mesh_faces *f, mesh *m, uint64_t count[REPORT_ITEMS]);

void faces_free(mesh_faces *f);

#endif
