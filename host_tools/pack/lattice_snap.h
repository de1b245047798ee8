/* lattice_snap - a mesh moved onto the lattice
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOST_LATTICE_SNAP_H
#define HOST_LATTICE_SNAP_H
#include "host_tools/pack/snapped.h"

/* Moves the mesh. Triangles without area on the lattice are left out; one that has an area
 * in the mesh counts in where the lattice lies, because whether it keeps its area depends on
 * that. Refuses a lattice finer than the floats around it. */
int lattice_snap_as(snapped *s, const mesh *m, const lattice_wish *wish, const char *name, fail *f);

/* The same with so many bits, and no other wish. */
int lattice_snap(snapped *s, const mesh *m, uint32_t bits, const char *name, fail *f);

#endif
