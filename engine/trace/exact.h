/* exact - on which side of a directed edge does a ray pass, and where does it meet a plane?
 *
 * For the cases of the ray/triangle test that single precision cannot decide. First comes
 * arithmetic in pairs of floats (about 46 bits), error-free where it matters; what is
 * smaller than its error bound stays open. The rest is computed in integers without any
 * error (wide.h), at some ten times the cost. So a side is never wrong.
 *
 * Sources: Dekker, "A floating-point technique for extending the available
 * precision", 1971; Knuth, TAOCP volume 2, section 4.2.2 (exact sums).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_EXACT_H
#define PLT_TRACE_EXACT_H

#include "engine/trace/wide.h"

/* Sign of dir . ((p - org) x (q - org)): 1, -1, or 0 when the ray passes the line through
 * p and q closer than about 2^-42 of its distance, and pairs cannot tell. */
int plt_edge_side(const float p[3], const float q[3], const float org[3], const float dir[3]);

/* The same value, and exactly its sign. */
plt_scaled plt_edge_value(const float p[3], const float q[3], const float org[3],
                          const float dir[3]);

/* Where the ray meets the triangle's plane, to 2^-21 of it; 0 if it is parallel. */
float plt_exact_distance(const float corner[3][3], const float org[3], const float dir[3]);

/* A power of two that brings the largest component (below 2^126) to 1 .. 2; all of them are
 * only brought closer if they are subnormal. */
float plt_power_to_one(const float v[3]);

#endif
