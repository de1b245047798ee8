/* lattice - the lattice for a mesh: how many bits, where it begins, how long a step
 *
 * The lattice is the scene's quantisation grid. Its step is
 * - the longest power of two of which all corners are multiples, where the mesh has one
 *   for which the bits suffice: integers, voxels, CAD in 64ths. No corner then moves;
 * - else the box's longest side / (2^bits - 2), its mantissa rounded up (SPEC.md, 4.7).
 *   With `power` it is the shortest power of two for which the bits suffice. That costs up
 *   to one bit, and corners that are multiples of it do not move.
 * A lattice of powers of two begins at a multiple of its step.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOST_LATTICE_H
#define HOST_LATTICE_H
#include <stdint.h>

#include "engine/base/box.h"
#include "engine/base/lattice.h"
#include "host_tools/base/fail.h"

typedef struct lattice_wish {
    uint32_t bits; /* 12 .. 21 */
    int power;     /* the step shall be a power of two */
    int fewest;    /* take fewer bits if no corner moves on them */
    int boxes;     /* it is for boxes alone: take fewer bits where floats are coarser */
} lattice_wish;

/* What lies on it: the corners' box, and the exponent of the largest power of two of which
 * all their coordinates are multiples; LATTICE_NO_GRAIN when all are 0. */
typedef struct lattice_ground {
    plt_box box;
    int grain;
} lattice_ground;

#define LATTICE_NO_GRAIN 1000

/* Of x, the same exponent; LATTICE_NO_GRAIN for 0. */
int lattice_grain(float x);

/* The length of the box's longest side. */
double lattice_longest(const plt_box *b);

/* Bits that keep every vertex within `tolerance` (a fraction of the longest side) of where
 * it was, unless floats round there as coarsely as the lattice or `power` is wanted; 0 when
 * 21 are not enough. */
uint32_t lattice_bits_for(double tolerance);

/* The lattice over the ground. Refuses one finer than the floats around it. */
int lattice_over(plt_lattice *lattice, const lattice_ground *ground, const lattice_wish *wish,
                 const char *name, fail *f);

#endif
