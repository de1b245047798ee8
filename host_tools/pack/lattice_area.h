/* lattice_area - whether a triangle has an area, on the lattice and in the mesh
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOST_LATTICE_AREA_H
#define HOST_LATTICE_AREA_H
#include "host_tools/pack/snapped.h"

/* On the lattice: has area; is flat, and its corners are three different points. */
int lattice_has_area(const lattice_position p[3]);
int lattice_is_line(const lattice_position p[3]);

/* Had an area in the mesh, computed in double. */
int lattice_had_area(const mesh *m, size_t triangle);

#endif
