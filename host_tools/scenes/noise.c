/* noise - a random number for every pair of integers, and smooth noise between them
 *
 * Sources: A. Appleby, MurmurHash3, 2011 (the finaliser's constants);
 * K. Perlin, "Improving Noise", SIGGRAPH 2002 (the quintic).
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/noise.h"

/* Flipping any bit of the arguments flips each bit of the result with a
 * probability of about one half. */
static uint32_t hash_of(uint32_t x, uint32_t z, uint32_t seed) {
    uint32_t h = x * 0x9E3779B1u ^ (z * 0x85EBCA77u + seed * 0xC2B2AE3Du);
    h = (h ^ h >> 16) * 0x85EBCA6Bu;
    h = (h ^ h >> 13) * 0xC2B2AE35u;
    return h ^ h >> 16;
}

double noise_unit(uint32_t x, uint32_t z, uint32_t seed) {
    return hash_of(x, z, seed) * (1.0 / 4294967296.0);
}

/* The gradient of the grid point x z, each part -1 .. 1, times the distance from it. */
static double ramp(uint32_t x, uint32_t z, uint32_t seed, double dx, double dz) {
    const uint32_t h = hash_of(x, z, seed);
    const double slope_x = (double)(h & 65535) * (2.0 / 65535.0) - 1.0;
    const double slope_z = (double)(h >> 16) * (2.0 / 65535.0) - 1.0;
    return slope_x * dx + slope_z * dz;
}

static int32_t floor_of(double x) {
    const int32_t whole = (int32_t)x;
    return whole - (x < whole);
}

static double ease(double t) {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

double noise_gradient(double x, double z, uint32_t seed) {
    const int32_t i = floor_of(x), k = floor_of(z);
    const double dx = x - i, dz = z - k, u = ease(dx), v = ease(dz);
    const uint32_t x0 = (uint32_t)i, z0 = (uint32_t)k, x1 = x0 + 1, z1 = z0 + 1;
    const double a = ramp(x0, z0, seed, dx, dz), b = ramp(x1, z0, seed, dx - 1.0, dz);
    const double c = ramp(x0, z1, seed, dx, dz - 1.0), d = ramp(x1, z1, seed, dx - 1.0, dz - 1.0);
    const double near = a + u * (b - a), far = c + u * (d - c);
    return near + v * (far - near);
}
