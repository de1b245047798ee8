/* lattice_parts - what moving a mesh and boxing it have in common
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOST_LATTICE_PARTS_H
#define HOST_LATTICE_PARTS_H
#include "host_tools/pack/lattice.h"

typedef struct lattice_position {
    uint32_t q[3];
} lattice_position;

/* q[0] of a vertex that no triangle uses: it is not counted and moves nowhere. */
#define LATTICE_UNUSED UINT32_MAX

/* A coordinate of the mesh in steps from the origin, not rounded. */
double lattice_steps(const snapped *s, const float p[3], int axis);

/* On the lattice: has area; is flat, and its corners are three different points. */
int lattice_has_area(const lattice_position p[3]);
int lattice_is_line(const lattice_position p[3]);

/* Had an area in the mesh, computed in double. */
int lattice_had_area(const mesh *m, size_t triangle);

/* Moves corners of triangles that have become lines; 0, or -1 when memory is out.
 * (lattice_mend.c) */
int lattice_mend(snapped *s, const mesh *m, lattice_position *moved);

/* The lattice of `bits` for the mesh, and room for `positions` per triangle. What
 * it allocates lattice_free frees, also after a failure. */
int lattice_begin(snapped *s, const mesh *m, uint32_t bits, uint32_t positions, const char *name,
                  fail *f);

/* One more triangle, of so many positions, made of the mesh's triangle `source`. */
void lattice_add(snapped *s, const lattice_position *p, uint32_t positions, uint32_t source);

#endif
