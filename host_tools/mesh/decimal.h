/* decimal - numbers in text, the same in every locale
 *
 * SPDX-License-Identifier: MIT */
#ifndef DECIMAL_H
#define DECIMAL_H
#include <stdint.h>

#include "host_tools/mesh/real.h"

/* Each reads the number that begins at `at` and returns the byte after it,
 * or NULL when there is none before `end`.
 *
 * Both values are the nearest ones, ties to even; too large gives infinity.
 * "nan", "inf", "infinity" and the "1.#QNAN" family are numbers here, so
 * that the caller can say what is wrong with them. */
const unsigned char *decimal_real(const unsigned char *at, const unsigned char *end, real *value);
const unsigned char *decimal_float(const unsigned char *at, const unsigned char *end, float *value);

/* A number beyond int64_t becomes its nearest end. */
const unsigned char *decimal_integer(const unsigned char *at, const unsigned char *end,
                                     int64_t *value);

#endif
