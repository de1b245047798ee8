/* lattice_area - whether a triangle has an area on the lattice
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOST_LATTICE_AREA_H
#define HOST_LATTICE_AREA_H
#include "host_tools/pack/snapped.h"

/* Has an area; is flat, and its corners are three different points. */
int lattice_has_area(const lattice_position p[3]);
int lattice_is_line(const lattice_position p[3]);

#endif
