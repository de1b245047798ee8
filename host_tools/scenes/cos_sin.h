/* cos_sin - cosine and sine without libm, the same on every machine
 *
 * SPDX-License-Identifier: MIT */
#ifndef COS_SIN_H
#define COS_SIN_H
#include <stdint.h>

typedef struct cos_sin {
    double cosine, sine;
} cos_sin;

/* Of the angle part / whole of a circle (whole 1 .. 2^61, any part), to within
 * 1e-15; quarters of the circle are exact. */
cos_sin cos_sin_of(uint64_t part, uint64_t whole);

#endif
