/* wide - exact sums of products of three floats
 *
 * For the few rays that single precision cannot decide. A sum is an integer
 * of 608 bits that counts 2^-447: every product of three finite floats is a multiple of
 * that, and as long as its factors are below 2^60, 2^43 and 2^43, 64 of them fit in.
 *
 * Source: Kulisch, "Computer arithmetic and validity", 2008 (the long accumulator); the
 * format is ours.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WIDE_H
#define PLT_TRACE_WIDE_H

#include <stdint.h>

enum { PLT_WIDE_LIMBS = 19 };

/* Two's complement, the lowest bits first; all 0 is 0. */
typedef struct plt_wide {
    uint32_t limb[PLT_WIDE_LIMBS];
} plt_wide;

/* A float with an exponent of its own: mantissa * 2^exponent, |mantissa| in 1 .. 2, or 0. */
typedef struct plt_scaled {
    float mantissa;
    int exponent;
} plt_scaled;

/* Adds a * b * c, without any error. */
void plt_wide_add(plt_wide *sum, float a, float b, float c);

/* The sum, to 2^-23 of itself and of its sign; `sum` is its magnitude then. */
plt_scaled plt_wide_value(plt_wide *sum);

/* 2^exponent times it, to the nearest float; `exponent` 0: the value itself. */
float plt_scaled_float(plt_scaled x, int exponent);

#endif
