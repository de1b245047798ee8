/* lattice_mend - slivers that the lattice has made lines of get an area again
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOST_LATTICE_MEND_H
#define HOST_LATTICE_MEND_H
#include "host_tools/pack/snapped.h"

/* Moves corners of triangles that have become lines: `moved` holds where each vertex of the
 * mesh has gone, or LATTICE_UNUSED. 0, or -1 when memory is out. */
int lattice_mend(snapped *s, const mesh *m, lattice_position *moved);

#endif
