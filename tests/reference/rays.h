/* rays - rays for tests: mixed, as from a camera, along the axes
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_RAYS_H
#define REFERENCE_RAYS_H

#include "engine/planelet.h"
#include "host_tools/mesh/mesh.h"
#include "tests/reference/random.h"

#define RAYS_FAR 3.0e38f

plt_ray ray_make(const float org[3], const float dir[3], float tmin, float tmax);
plt_ray ray_between(const float from[3], const float to[3]);

/* From around the mesh through its box, one in four with a finite tmax. */
void rays_random(plt_ray *rays, uint32_t count, const mesh *m, random_state *r);

/* One origin, a square image (rows of `side` with side^2 <= count), looking at the middle of
 * the mesh. */
void rays_camera(plt_ray *rays, uint32_t count, const mesh *m, random_state *r);

/* Along an axis, zeros of either sign in the others, starting at vertices'
 * coordinates half the time. */
void rays_axis(plt_ray *rays, uint32_t count, const mesh *m, random_state *r);

/* Towards vertices, towards random points of edges, and from the plane of a triangle towards a
 * point in it, as exactly as floats allow. */
void rays_edges(plt_ray *rays, uint32_t count, const mesh *m, random_state *r);

/* A third of each of the first three. */
void rays_mixed(plt_ray *rays, uint32_t count, const mesh *m, random_state *r);

#endif
