/* number - numbers of a command line, without libc and without rounding twice
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_NUMBER_H
#define PLT_BOARD_NUMBER_H

#include <stdint.h>

/* Decimal digits only; -1 when empty, not a number or 2^32 and more. */
int number_u32(const char *text, unsigned length, uint32_t *value);

/* A float, rounded to nearest even, from either
 *   0x3f800000    its bits, exact by nature, or
 *   -12.5e-3      a decimal number: 0, or at most 18 digits (leading zeros
 *                 not counted), below 1e18, at most 26 digits after the point.
 * Nine digits, as "%.9g" prints them, restore every float in 1e-18 .. 1e18.
 * -1 when it is neither. */
int number_float(const char *text, unsigned length, float *value);

#endif
