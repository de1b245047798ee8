/* turns - sine and cosine without libm, the same on every machine
 *
 * SPDX-License-Identifier: MIT */
#ifndef TURNS_H
#define TURNS_H
#include <stdint.h>

typedef struct turn {
    double cosine, sine;
} turn;

/* Of the angle of part / whole turns (whole 1 .. 2^61, any part), to within
 * 1e-15; quarter turns are exact. */
turn turn_of(uint64_t part, uint64_t whole);

#endif
