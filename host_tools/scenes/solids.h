/* solids - the closed surfaces that furniture is made of
 *
 * Every call adds one closed surface: each edge has two triangles, one in each direction,
 * counter-clockwise seen from outside. Surfaces of two calls share no vertices.
 *
 * Lengths are the scene's, half sizes where the name says `half`; a place's axis 1 is up.
 * Curved surfaces have the divisions that are asked for times the detail (solids_add.h).
 *
 * SPDX-License-Identifier: MIT */
#ifndef SOLIDS_H
#define SOLIDS_H
#include "host_tools/scenes/solids_add.h"

/* A block of cells[0] x cells[1] x cells[2] cells, of which the surface remains. `shape`
 * moves a point of the cube -1 .. 1 to its place; it must not fold the surface. */
typedef void (*solid_shape)(const void *how, double p[3]);
void solid_block(solids *s, const place *at, const unsigned cells[3], solid_shape shape,
                 const void *how);

/* Their middle is at their place. */
void solid_box(solids *s, const place *at, double half_x, double half_y, double half_z);
/* With edges rounded to `radius`, which is less than each half size. */
void solid_rounded(solids *s, const place *at, const double half[3], double radius);
/* An ellipsoid; `divisions` along a quarter of its circumference, times two. */
void solid_ball(solids *s, const place *at, const double half[3], unsigned divisions);

/* A point of a profile. From it to the next the profile is straight, or a smooth curve. */
typedef struct solid_point {
    double radius, height;
    int is_curved;
} solid_point;

/* A profile rotated about the place's axis 1. It begins and ends on the axis, with a radius
 * of 0, has another radius between, and runs counter-clockwise: from below to above
 * for what has no inside. */
void solid_lathe(solids *s, const place *at, const solid_point *profile, unsigned points,
                 unsigned sides);

/* A cylinder of that radius and height; the middle of its base is at its place. */
void solid_rod(solids *s, const place *at, double radius, double height, unsigned sides);

#endif
