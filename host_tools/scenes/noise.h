/* noise - a random number for every pair of integers, and smooth noise between them
 *
 * SPDX-License-Identifier: MIT */
#ifndef NOISE_H
#define NOISE_H
#include <stdint.h>

/* 0 .. 1, 1 excluded. */
double noise_unit(uint32_t x, uint32_t z, uint32_t seed);

/* Gradient noise: -1 .. 1, 0 at whole numbers, second derivative continuous;
 * |x|, |z| < 2^31. */
double noise_gradient(double x, double z, uint32_t seed);

#endif
