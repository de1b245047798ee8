/* grid_scenes - random meshes that are bad for cells of one size
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_GRID_SCENES_H
#define REFERENCE_GRID_SCENES_H

#include "engine/grid/grid.h"
#include "host_tools/mesh/mesh.h"
#include "tests/reference/random.h"

/* Returns its kind, for messages. At scales of 2^-30 to 2^30, up to 2^16 of its sizes from 0. */
unsigned grid_scene_make(mesh *m, random_state *r);

/* Another shape of the same triangles. `grid`: corners may be put on faces of its cells. */
void grid_scene_deform(mesh *m, const plt_grid *grid, random_state *r);

#endif
