/* twist - a mesh whose upper part rotates to and fro, for lack of the frames of an animation
 *
 * SPDX-License-Identifier: MIT */
#ifndef TWIST_H
#define TWIST_H
#include "host_tools/mesh/mesh.h"

/* Each vertex rotates about the vertical through the middle, by an angle in proportion to its
 * height over the lowest: the uppermost from 0 in step 0 to a quarter of a circle half way through
 * and back. steps >= 1, step < steps. The same on every machine. */
void twist_mesh(mesh *m, unsigned step, unsigned steps);

#endif
