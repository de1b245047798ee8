/* orient2 - on which side of a line a point lies, exactly
 *
 * SPDX-License-Identifier: MIT */
#ifndef ORIENT2_H
#define ORIENT2_H

/* Twice the signed area of the triangle a b c: positive when it turns left. The sign
 * is exact, the amount nearly so. Coordinates are 0 or of size 2^-400 to 2^400. */
double orient2(const double a[2], const double b[2], const double c[2]);

#endif
