/* exact_rational - a ray and a triangle in integers, without any error
 *
 * Every float is an integer times a power of two, so edge functions, distance and weights
 * are ratios of integers; these have as many bits as they need. Shares nothing with the
 * engine's own integers (engine/trace/wide.h).
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_EXACT_RATIONAL_H
#define REFERENCE_EXACT_RATIONAL_H

#include <stdint.h>

#include "engine/planelet.h"

enum { EXACT_LIMBS = 32 };

/* Sign and magnitude; limb[0] is the lowest, limb[used - 1] is not 0. */
typedef struct exact_integer {
    int sign; /* -1, 0, 1 */
    int used;
    uint32_t limb[EXACT_LIMBS];
} exact_integer;

/* x / 2^unit, which must be an integer. */
exact_integer exact_of(float x, int unit);
exact_integer exact_sum(const exact_integer *a, const exact_integer *b);
exact_integer exact_difference(const exact_integer *a, const exact_integer *b);
exact_integer exact_product(const exact_integer *a, const exact_integer *b);

/* a / b to 2^-50 of it; b is not 0. */
double exact_ratio(const exact_integer *a, const exact_integer *b);

/* What is so of the whole line of a ray, whatever tmin and tmax are. */
typedef struct exact_answer {
    int meets;        /* the triangle, edges and corners included, and not in its plane */
    double t, u, v;   /* if it meets; to 2^-50 of themselves */
    double cosine;    /* of the angle between ray and normal; 0: in its plane, or no area */
    double normal[3]; /* of length 1; 0: no area */
} exact_answer;

exact_answer exact_triangle(const float corner[3][3], const plt_ray *ray);

#endif
