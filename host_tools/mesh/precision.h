/* precision - what single precision does to the edges of a mesh
 *
 * SPDX-License-Identifier: MIT */
#ifndef PRECISION_H
#define PRECISION_H
#include "host_tools/mesh/mesh.h"

typedef struct precision {
    double moved;      /* greatest distance by which a corner moves */
    double relative;   /* the same in lengths of an edge that ends there, the greatest
                        * such, at most a million */
    uint64_t vanished; /* triangles an edge of which loses its length */
} precision;

/* Worth a word: more than REPORT_MOVED_MOST of an edge, or an edge gone. */
static inline int precision_matters(const precision *p) {
    return p->relative > REPORT_MOVED_MOST || p->vanished > 0;
}

/* Of the triangles first .. end - 1, when the mesh is moved by -origin and then narrowed. */
precision precision_of(const mesh *m, size_t first, size_t end, const double origin[3]);

/* The middle of the box of the corners of all triangles, as the files have them; 0 without. */
void precision_centre(const mesh *m, double centre[3]);

/* Moves the mesh by -origin, narrows it, and drops the wide coordinates. Fails when a used
 * vertex leaves +-PLT_COORD_MAX; unused ones then go to 0. */
int precision_settle(mesh *m, const double origin[3], const char *path, fail *f);

#endif
