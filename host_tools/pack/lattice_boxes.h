/* lattice_boxes - boxes on the lattice around triangles that stay where they are
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOST_LATTICE_BOXES_H
#define HOST_LATTICE_BOXES_H
#include "host_tools/pack/snapped.h"

/* Leaves the mesh where it is: `corners` become the triangles' boxes (6
 * coordinates each), rounded outwards, of all triangles. */
int lattice_boxes(snapped *s, const mesh *m, const lattice_wish *wish, const char *name, fail *f);

#endif
