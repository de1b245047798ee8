/* triangle_common - what every test of rays against triangles has in common
 *
 * Error bounds (u = 2^-24; R = the ray's reach, at least the distance from its
 * origin to any corner on any axis; X = the largest sheared coordinate):
 *   a sheared coordinate       6 u R     one rounding each for both
 *                                        differences, 3 for slope * depth, 2
 *                                        for the last difference
 *   an edge function           4 * 6 u R * X + 72 u^2 R^2 + 4 u X^2, and as
 *                              X <= 2 R, at most 32 u R X + 128 u^2 R^2
 * Rays that meet the triangle have X <= 2 L + 6 u R, L being the longest side
 * of the triangle's box, so their edge functions are no further on the wrong
 * side than 64 u R L + 264 u^2 R^2. All beyond 72 u R L + 320 u^2 R^2 needs no
 * second look. R is at least 2^-50 (packet_set.c), so that what underflows is less
 * than the rest of these bounds, in scenes of any size.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRIANGLE_COMMON_H
#define PLT_TRACE_TRIANGLE_COMMON_H

#include <stdint.h>

#define PLT_U 5.9604644775390625e-8f /* 2^-24 */
#define PLT_SLIVER 9.765625e-4f      /* 2^-10: a sliver, by the sine of its first angle */
#define PLT_GRAZING 2.44140625e-4f   /* 2^-12: n . dir, for edges and dir of 1 to 2 */

/* Below 2^-63 products of a normal may underflow; of one of edges of 1 to 2, times 2^80,
 * they do not. */
#define PLT_NORMAL_LEAST 1.0842021724855044e-19f
#define PLT_NORMAL_SCALE 1.2089258196146292e24f

/* Of axes, and of corners. */
static const uint8_t plt_axis_after[3] = {1, 2, 0};

static inline void plt_cross(const float a[3], const float b[3], float to[3]) {
    to[0] = a[1] * b[2] - a[2] * b[1];
    to[1] = a[2] * b[0] - a[0] * b[2];
    to[2] = a[0] * b[1] - a[1] * b[0];
}

static inline void plt_triangle_normal(const float c[3][3], float normal[3]) {
    const float first[3] = {c[1][0] - c[0][0], c[1][1] - c[0][1], c[1][2] - c[0][2]};
    const float second[3] = {c[2][0] - c[0][0], c[2][1] - c[0][1], c[2][2] - c[0][2]};
    plt_cross(first, second, normal);
}

/* Of |n . dir|: a sliver's, and that of a normal below PLT_NORMAL_LEAST, is less than three
 * times what limits each of its three components. `longest`: at least the longest side. */
static inline float plt_open_limit(float longest) {
    return 4.0f * PLT_SLIVER * longest * longest + 4.0f * PLT_NORMAL_LEAST;
}

#endif
