/* brute - every triangle, in double, with margins
 *
 * A verdict is certain only where no rounding of a single precision tracer
 * could change it: rays that pass an edge closer than its error are UNSURE.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_BRUTE_H
#define REFERENCE_BRUTE_H

#include "engine/planelet.h"
#include "host_tools/mesh/mesh.h"

enum brute_verdict { BRUTE_MISS, BRUTE_UNSURE, BRUTE_HIT };

typedef struct brute_answer {
    enum brute_verdict verdict;
    double t, t_error; /* t_error infinite: the plane is seen edge on */
    double u, v, u_error, v_error;
} brute_answer;

/* One triangle, without regard to tmin and tmax. */
brute_answer brute_triangle(const mesh *m, uint32_t triangle, const plt_ray *ray);

/* NULL when `hit` can be right, else what is wrong with it. `*unsure` is set when the reference
 * could not decide. Only for valid rays. */
const char *brute_objects(const mesh *m, const plt_ray *ray, const plt_hit *hit, int *unsure);

#endif
