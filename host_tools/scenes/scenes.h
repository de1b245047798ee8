/* scenes - meshes that need no download, the same on every machine
 *
 * Deterministic: integer random numbers, and no libm result that differs
 * between machines reaches a vertex unrounded.
 *
 * SPDX-License-Identifier: MIT */
#ifndef SCENES_H
#define SCENES_H
#include "host_tools/mesh/mesh.h"

/* A flat slab of 12 triangles (the thesis's "ground"). */
int scene_ground(mesh *m, fail *f);

/* 110 marbles of 80 triangles (8,800 in all) rolling in a tray; frame
 * `frame` of an animation at 25 frames a second. The simulation starts
 * over for frame 0, so that any frame can be asked for. */
int scene_marbles(mesh *m, unsigned frame, fail *f);

/* A height field of about `triangles` (2 .. 10,000,000) triangles. */
int scene_terrain(mesh *m, uint64_t triangles, fail *f);

/* A closed torus knot tube of about `triangles` (24 .. 10,000,000). */
int scene_knot(mesh *m, uint64_t triangles, fail *f);

#endif
