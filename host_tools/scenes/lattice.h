/* lattice - random numbers of whole numbers, and smooth noise between them
 *
 * SPDX-License-Identifier: MIT */
#ifndef LATTICE_H
#define LATTICE_H
#include <stdint.h>

/* Any bit of the arguments changes every bit of the result with a chance of
 * about one half. */
uint32_t lattice_hash(uint32_t x, uint32_t z, uint32_t seed);
double lattice_unit(uint32_t x, uint32_t z, uint32_t seed); /* 0 .. 1, 1 excluded */

/* Gradient noise: -1 .. 1, 0 at whole numbers, second derivative continuous;
 * |x|, |z| < 2^31. */
double lattice_noise(double x, double z, uint32_t seed);

#endif
