/* real - one number of a file, rounded to nearest in two precisions
 *
 * `single` is what the engine traces. `wide` is kept beside it until a mesh has
 * been moved to its origin, and for saying what single precision costs. Rounding
 * `wide` again would not always give `single`.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REAL_H
#define REAL_H

typedef struct real {
    float single;
    double wide;
} real;

/* Of a float, which is exact in both. */
static inline real real_of_float(float value) {
    return (real){value, (double)value};
}

#endif
