/* position - what is asked of a position wherever one is read, moved or compared
 *
 * SPDX-License-Identifier: MIT */
#ifndef POSITION_H
#define POSITION_H
#include <math.h>

#include "engine/planelet_config.h"

/* A coordinate that an image can hold; false for NaN. */
static inline int coordinate_is_valid(double x) {
    return fabs(x) <= (double)PLT_COORD_MAX;
}

/* At one place: 0 and -0 are equal. */
static inline int positions_are_equal(const float *p, const float *q) {
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/* Of a box; 0 when it is empty. */
static inline double longest_side(const double low[3], const double high[3]) {
    double longest = 0;
    for (int axis = 0; axis < 3; axis++) {
        longest = fmax(longest, high[axis] - low[axis]);
    }
    return longest;
}

#endif
