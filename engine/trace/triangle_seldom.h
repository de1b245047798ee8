/* triangle_seldom - one ray and one triangle that single precision does not decide
 *
 * What the tests of rays against triangles ask seldom: of one ray and one triangle at a
 * time, whatever lanes they come from. All of it is compiled for size in firmware.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRIANGLE_SELDOM_H
#define PLT_TRACE_TRIANGLE_SELDOM_H

#include "engine/trace/triangle_common.h"

/* A ray, out of its lanes. */
typedef struct plt_lone_ray {
    float org[3], dir[3];
    float reach; /* at least the distance to any corner on any axis */
    int z;       /* axis of the largest component of dir, along which it is sheared */
} plt_lone_ray;

/* What is known of the ray's way past a triangle. */
typedef struct plt_lone_edges {
    float weight[3];  /* edge functions: of each corner, that of the edge across from it */
    float x[3], y[3]; /* sheared corners */
    float error;      /* of each edge function */
} plt_lone_edges;

enum plt_meeting {
    PLT_MISSES,
    PLT_MEETS,
    PLT_MEETS_COARSELY /* u and v want plt_exact_weights */
};

/* Does the ray meet the triangle? Never wrong: an edge function above its error has the
 * right sign, those of the others come from integers. */
enum plt_meeting plt_decide_meeting(const plt_lone_ray *ray, const float corner[3][3],
                                    const plt_lone_edges *e);

/* Edge functions without errors, times a factor that all three have in common. */
void plt_exact_weights(const plt_lone_ray *ray, const float corner[3][3], float weight[3]);

/* The normal times a power of two, so large that none of its products underflows, and
 * what kind of normal it is: bits. */
enum plt_normal_kind {
    PLT_NORMAL_IS_SMALL = 1, /* below PLT_NORMAL_LEAST: take the scaled one instead */
    PLT_NORMAL_IS_SLIVER = 2 /* of a sliver */
};
unsigned plt_scale_normal(const float corner[3][3], const float normal[3], float scaled[3]);

/* Whether t needs integers (plt_exact_distance), if the triangle is hit: n . dir is mostly
 * rounding; or the triangle is a sliver, and so close that the clamp may leave open whether
 * it is met before or after tmin. `along`: scaled normal . dir over dir[z]; `kind`: of the
 * normal; enter, leave: of the triangle's own box. */
static inline int plt_distance_is_open(float along, unsigned kind, float enter, float leave) {
    return __builtin_fabsf(along) < PLT_GRAZING * PLT_NORMAL_SCALE ||
           ((kind & PLT_NORMAL_IS_SLIVER) != 0 && enter + enter <= leave);
}

#endif
