/* triangle_ray - one ray against one triangle
 *
 * What triangle.h says, for a machine without lanes and for rays that come one at a time:
 * the same operations on the same operands, so hits have the same t, u, v and normal, bit for
 * bit (test_trace_ray). Rays start at one point and have the interval 0 .. tmax.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRIANGLE_RAY_H
#define PLT_TRACE_TRIANGLE_RAY_H

#include <stdint.h>

#include "engine/base/box.h"

/* What all rays from one point have in common. */
typedef struct plt_ray_origin {
    float org[3];
    float reach;          /* largest distance on any axis from org to the scene's box */
    float up[3], down[3]; /* org moved by the rounding bound of packet_set.c, either way */
} plt_ray_origin;

/* `scene`: the box of all that may be hit; org within PLT_COORD_MAX. */
void plt_ray_origin_set(plt_ray_origin *o, const plt_box *scene, const float org[3]);

typedef struct plt_ray_hit {
    float t;
    float weight[3]; /* edge functions: u and v are ratios of them */
    float normal[3]; /* not normalised */
} plt_ray_hit;

/* Is there a hit before tmax, or, if `wins_ties`, at it? Fills in `hit` if there is; else its
 * contents are lost. A direction of no length (largest component below 2^-60) hits nothing;
 * that component must not be above 2^60. */
int plt_triangle_ray(const plt_ray_origin *o, const float dir[3], const float corner[3][3],
                     float tmax, int wins_ties, plt_ray_hit *hit);

/* u and v of a hit, by the triangle's rotation (primitive_id.h). */
void plt_ray_hit_weights(const plt_ray_hit *hit, uint32_t rotation, float *u, float *v);

/* The normal that such a hit has, of any ray. */
void plt_hit_normal(const float corner[3][3], float normal[3]);

#endif
