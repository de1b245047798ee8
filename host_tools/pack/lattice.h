/* lattice - the lattice for a mesh: how many bits, and how long a step
 *
 * The lattice is the scene's quantisation grid.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOST_LATTICE_H
#define HOST_LATTICE_H
#include <stdint.h>

#include "engine/base/box.h"
#include "engine/base/lattice.h"
#include "host_tools/base/fail.h"

/* Bits that keep every vertex within `tolerance` (a fraction of the longest
 * side) of where it was; 0 when 21 are not enough. */
uint32_t lattice_bits_for(double tolerance);

/* The lattice of `bits` over a box. Refuses one finer than the floats around it. */
int lattice_over(plt_lattice *lattice, const plt_box *box, uint32_t bits, const char *name,
                 fail *f);

#endif
