/* place - where a part of a scene stands and how it is rotated
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLACE_H
#define PLACE_H

/* Axes at right angles and of unit length, and the origin: a rigid motion. */
typedef struct place {
    double axis[3][3], at[3];
} place;

place place_at(double x, double y, double z); /* not rotated */
/* Moved along the place's own axes. */
place place_moved(const place *p, double x, double y, double z);
/* Rotated about its own axis 0 .. 2 by that part of a circle, -1 .. 1, counter-clockwise. */
place place_rotated(const place *p, unsigned axis, double circles);
/* From the place's own coordinates to the scene's. */
void place_point(const place *p, const double local[3], double to[3]);

#endif
