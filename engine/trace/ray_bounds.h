/* ray_bounds - how far directions and reaches go, and how far origins move
 *
 * How far origins are moved (e, per axis; u = 2^-24, R = the reach, the largest
 * distance on any axis from the origin to the scene's box): a plane's distance
 * is off by at most 3 u of itself, on each of two axes that are compared. So
 * e = 16 u R, or 4 u |org| where that is more so that the sum does not round
 * away; at least 12 u R of it are left, and a box that a ray meets is never
 * missed. R is made at least 2^-50: what rounding takes from subnormal numbers is far less
 * than 16 u of that, and the bounds of triangle_common.h hold too. The idea is Woop, Benthin
 * and Wald, "Watertight ray/triangle intersection", 2013, section 5.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_RAY_BOUNDS_H
#define PLT_TRACE_RAY_BOUNDS_H

#define PLT_DIR_MOST 1.152921504606846976e18f   /* 2^60 */
#define PLT_DIR_LEAST 8.67361737988403547e-19f  /* 2^-60, also of a component to the largest */
#define PLT_BOX_ERROR 9.5367431640625e-7f       /* 16 u = 2^-20 */
#define PLT_ORIGIN_ERROR 2.384185791015625e-7f  /* 4 u = 2^-22 */
#define PLT_REACH_LEAST 8.8817841970012523e-16f /* 2^-50 */
#define PLT_REACH_ROUNDING 1.000001f            /* the differences were rounded */
#define PLT_CLOSE_ERROR 1.1368683772161603e-12f /* 320 u^2, of reach^2: triangle_common.h */
#define PLT_SURE_ERROR 7.62939453125e-6f /* 128 u, of reach times e: DESIGN.md, section 7.8 */

#endif
