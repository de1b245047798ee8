/* cos_sin - cosine and sine without libm, the same on every machine
 *
 * The angle is reduced to 0 .. 1/8 of the circle in integers, and so exactly;
 * Taylor polynomials in double do the rest. At pi/4 the first
 * terms left out are below 2e-17 and 1e-18.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/cos_sin.h"

#define QUARTER 1.57079632679489661923 /* pi / 2, radians */

static double sine_near_0(double a) {
    const double s = a * a;
    double sum = 1.0 / 355687428096000.0; /* 17! */
    sum = sum * s - 1.0 / 1307674368000.0;
    sum = sum * s + 1.0 / 6227020800.0;
    sum = sum * s - 1.0 / 39916800.0;
    sum = sum * s + 1.0 / 362880.0;
    sum = sum * s - 1.0 / 5040.0;
    sum = sum * s + 1.0 / 120.0;
    sum = sum * s - 1.0 / 6.0;
    return a + a * s * sum;
}

static double cosine_near_0(double a) {
    const double s = a * a;
    double sum = 1.0 / 20922789888000.0; /* 16! */
    sum = sum * s - 1.0 / 87178291200.0;
    sum = sum * s + 1.0 / 479001600.0;
    sum = sum * s - 1.0 / 3628800.0;
    sum = sum * s + 1.0 / 40320.0;
    sum = sum * s - 1.0 / 720.0;
    sum = sum * s + 1.0 / 24.0;
    return 1.0 - 0.5 * s + s * s * sum;
}

cos_sin cos_sin_of(uint64_t part, uint64_t whole) {
    const uint64_t quarters = part % whole * 4, rest = quarters % whole;
    const int folded = 2 * rest > whole; /* past the eighth: sine and cosine are exchanged */
    const double a = QUARTER * (double)(folded ? whole - rest : rest) / (double)whole;
    const double s = folded ? cosine_near_0(a) : sine_near_0(a);
    const double c = folded ? sine_near_0(a) : cosine_near_0(a);
    switch (quarters / whole) {
    case 0:
        return (cos_sin){c, s};
    case 1:
        return (cos_sin){-s, c};
    case 2:
        return (cos_sin){-c, -s};
    default:
        return (cos_sin){s, -c};
    }
}
