/* lattice_parts - what moving a mesh and boxing it have in common
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOST_LATTICE_PARTS_H
#define HOST_LATTICE_PARTS_H
#include "host_tools/pack/lattice.h"

typedef struct lattice_position {
    uint32_t q[3];
} lattice_position;

/* The lattice of `bits` for the mesh, and room for `positions` a triangle. What
 * it has cut is freed by lattice_free, also when it fails. */
int lattice_begin(snapped *s, const mesh *m, uint32_t bits, uint32_t positions, const char *name,
                  fail *f);

/* One more triangle, of so many positions, made of number `source`. */
void lattice_add(snapped *s, const lattice_position *p, uint32_t positions, uint32_t source);

#endif
