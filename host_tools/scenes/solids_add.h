/* solids_add - where solids are added to a mesh, and how: vertices and triangles
 *
 * SPDX-License-Identifier: MIT */
#ifndef SOLIDS_ADD_H
#define SOLIDS_ADD_H
#include "host_tools/mesh/mesh.h"
#include "host_tools/scenes/place.h"

typedef struct solids {
    mesh *m;            /* NULL: triangles are counted, not made */
    uint64_t triangles; /* so far */
    unsigned detail;    /* of curved surfaces, in 32nds */
    int is_hollow;      /* what follows is a cavity: outside is within */
    int wrong;          /* memory is out, `f` says so; calls do nothing any more */
    fail *f;
} solids;

/* Divisions for a curve that has `normal` at a detail of 1: at least 1. */
unsigned solid_divisions(const solids *s, unsigned normal);

/* Counts the triangles of a solid; true when that is all. */
int solids_only_count(solids *s, uint64_t triangles);
uint32_t solids_first(const solids *s); /* index of the next vertex */
void solids_vertex(solids *s, const place *at, const double local[3]);
void solids_triangle(solids *s, uint32_t a, uint32_t b, uint32_t c);
void solids_quad(solids *s, uint32_t a, uint32_t b, uint32_t c, uint32_t d);

#endif
