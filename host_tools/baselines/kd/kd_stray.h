/* kd_stray - which cells a triangle is for, where cells cut triangles
 *
 * A cell may hold references to the triangles whose boxes reach into it, or only to those that
 * reach into it themselves, which are fewer ("perfect splits"). The engine reports a hit at q, near
 * the triangle's plane and its box (lone_ray.h), but not always near the triangle: t * |dir| is off
 * by up to 2^-19 D / (s c) (planelet.h), D being the distance to the farthest corner, s the sine of
 * the smallest angle, c the cosine between ray and normal. So q is off the plane by h = 2^-19 D / s
 * at most, whatever c is, and where c is at least 1/16 off the triangle by 16 h.
 *
 * Therefore a cell holds
 *
 *   references  to triangles that come within 16 h of it, for every ray, and
 *   strays      whose plane comes within h and whose box reaches into it, for grazing rays, of
 *               which c is below 1/16: a product with the normal tells them, and puts others aside.
 *
 * All distances are widened by `margin`, which is 4 e (lone_ray.h) of rays whose reach is at most
 * `reach`. Rays that come from farther off are traced through all cells of their line: the point
 * where the line meets the triangle lies in one that has a reference. A sliver, s below 2^-6, and
 * what lies nearly across an axis, are in all cells that their boxes reach into.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_KD_STRAY_H
#define BASELINES_KD_STRAY_H

#include "host_tools/baselines/base/triangle_set.h"

typedef struct kd_plane {
    float normal[3]; /* of length 1 */
    float off;       /* h; below 0: a sliver, across an axis, or nothing that has a plane */
} kd_plane;

typedef struct kd_scene {
    const triangle_set *triangles;
    kd_plane *plane; /* NULL: cells hold references by boxes alone */
    float margin, reach;
} kd_scene;

/* A part of a triangle's box. */
typedef struct kd_reference {
    float lo[3], hi[3];
    uint32_t triangle;
} kd_reference;

/* The plane's memory stays, if there is some. -1: no memory. */
int kd_scene_set(kd_scene *s, const triangle_set *triangles, int is_clipped);
void kd_scene_free(kd_scene *s);

/* The box of a triangle, widened; cells within have references to it, or strays. */
kd_reference kd_whole(const kd_scene *s, uint32_t triangle);

/* Cuts `r` to what cell lo .. hi has of it; 0: nothing. */
int kd_clip(const kd_scene *s, kd_reference *r, const float lo[3], const float hi[3]);

/* Whether a triangle that is not in the cell has to be one of its strays. */
int kd_is_stray(const kd_scene *s, uint32_t triangle, const float lo[3], const float hi[3]);

/* Whether a stray may have a hit of a ray in that direction. */
static inline int kd_is_grazing(const kd_plane *p, const float dir[3]) {
    const float c = p->normal[0] * dir[0] + p->normal[1] * dir[1] + p->normal[2] * dir[2];
    const float length = dir[0] * dir[0] + dir[1] * dir[1] + dir[2] * dir[2];
    return c * c < 0.004f * length; /* above 1 / 16^2 */
}

#endif
