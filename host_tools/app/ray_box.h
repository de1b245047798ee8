/* ray_box - rays that a scene's box alone decides, and the random numbers of all
 *
 * Source: Marsaglia, "Xorshift RNGs", 2003; "Choosing a Point from the Surface of a Sphere",
 * 1972; Santalo, "Integral Geometry", 1976 (lines of equal density meet a convex body in
 * proportion to its surface, which the SAH assumes of rays).
 *
 * SPDX-License-Identifier: MIT */
#ifndef RAY_BOX_H
#define RAY_BOX_H
#include "engine/planelet.h"

typedef struct ray_set {
    plt_ray *rays; /* owned */
    uint32_t count;
} ray_set;

/* tmin is 0. */
void ray_set_add(ray_set *s, const double org[3], const double dir[3], float tmax);

double ray_random(uint64_t *state); /* 0 <= x < 1 */
uint32_t ray_random_below(uint64_t *state, uint32_t count);

void ray_normalise(double v[3]);
/* Two unit vectors at right angles to `normal`, which has unit length, and to each other. */
void ray_frame(const double normal[3], double side[3], double over[3]);

/* Each adds `count` rays without an end. */
void ray_box_sides(ray_set *s, const plt_info *info, uint32_t count, uint64_t *random);
void ray_box_outside(ray_set *s, const plt_info *info, uint32_t count, uint64_t *random);
void ray_box_inside(ray_set *s, const plt_info *info, uint32_t count, uint64_t *random);

#endif
