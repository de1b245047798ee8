/* orient2 - on which side of a line a point lies, exactly
 *
 * SPDX-License-Identifier: MIT */
#ifndef ORIENT2_H
#define ORIENT2_H

/* Twice the signed area of the triangle a b c: positive when it turns left. The sign
 * is exact, the amount nearly so. Coordinates are 0 or of size 2^-400 to 2^400. */
double orient2(const double a[2], const double b[2], const double c[2]);

/* How much of that can be chance when coordinates are known to within `noise`. */
double orient2_noise(double noise, const double a[2], const double b[2], const double c[2]);

#endif
