/* math - the functions of C's math.h that the page's program calls
 *
 * Browsers compute sine, cosine, tangent and their inverse; an instruction has the square root, the
 * floor and the size, and the rest is exact (math.c).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WEB_MATH_H
#define PLT_WEB_MATH_H

#define HUGE_VAL __builtin_huge_val()
#define isfinite(x) __builtin_isfinite(x)
#define sqrt(x) __builtin_sqrt(x)
#define floor(x) __builtin_floor(x)
#define floorf(x) __builtin_floorf(x)
#define fabs(x) __builtin_fabs(x)

double sin(double x);
double cos(double x);
double tan(double x);
double asin(double x);
double fmod(double x, double y);
double fmin(double x, double y);
double fmax(double x, double y);

#endif
