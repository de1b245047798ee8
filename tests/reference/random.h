/* random - deterministic random numbers for tests
 *
 * The same on every machine: a test that fails once always fails.
 *
 * Source: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014
 * (SplitMix64).
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_RANDOM_H
#define REFERENCE_RANDOM_H

#include <stdint.h>

typedef struct random_state {
    uint64_t at;
} random_state;

static inline uint64_t random_bits(random_state *r) {
    uint64_t z = r->at += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
}

/* 0 .. limit - 1 */
static inline uint32_t random_below(random_state *r, uint32_t limit) {
    return (uint32_t)((random_bits(r) >> 32) * limit >> 32);
}

/* lo <= x < hi, but for rounding */
static inline float random_float(random_state *r, float lo, float hi) {
    const float unit = (float)(random_bits(r) >> 40) * 5.9604644775390625e-8f;
    return lo + unit * (hi - lo);
}

static inline void random_point(random_state *r, const float lo[3], const float hi[3],
                                float point[3]) {
    for (int a = 0; a < 3; a++) {
        point[a] = random_float(r, lo[a], hi[a]);
    }
}

#endif
