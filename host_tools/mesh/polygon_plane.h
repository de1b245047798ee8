/* polygon_plane - the corners of a face as points of its plane
 *
 * SPDX-License-Identifier: MIT */
#ifndef POLYGON_PLANE_H
#define POLYGON_PLANE_H
#include <stdint.h>

/* Looks at n >= 3 corners along their Newell normal: `to` receives points within +-4,
 * around which the outline turns left. Equal corners give equal points. Returns how far
 * the rounding of the corners to single precision can have moved a coordinate of a
 * point, or a negative number when all corners lie on one line, exactly. */
double polygon_project(const double (*corner)[3], uint32_t n, double (*to)[2]);

#endif
