/* exact - on which side of a directed edge does a ray pass, and where does it meet a plane?
 *
 * For the cases of the ray/triangle test that single precision cannot decide: computed in
 * integers without any error (wide.h).
 *
 * Source: Knuth, TAOCP volume 2, section 4.2.2 (exact sums).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_EXACT_H
#define PLT_TRACE_EXACT_H

#include "engine/trace/wide.h"

/* dir . ((p - org) x (q - org)), to 2^-23 of itself and exactly its sign: 0 if and only if the
 * ray runs through the line of p and q. */
plt_scaled plt_edge_value(const float p[3], const float q[3], const float org[3],
                          const float dir[3]);

/* Where the ray meets the triangle's plane, to 2^-21 of it; 0 if it is parallel. */
float plt_exact_distance(const float corner[3][3], const float org[3], const float dir[3]);

/* A power of two that brings the largest component (below 2^126) to 1 .. 2; all of them are
 * only brought closer if they are subnormal. */
float plt_power_to_one(const float v[3]);

#endif
