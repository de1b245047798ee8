/* orient2 - see orient2.h
 *
 * The difference of two products in double precision, trusted where its error
 * bound lets it; else the six products of the determinant are added as an
 * expansion, which loses nothing.
 * Source: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast
 * Robust Geometric Predicates", 1997, figures 2 and 6 to 8, and its bound
 * ccwerrboundA; the low half of a product is one fused operation.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/orient2.h"

#include <math.h>

static const double ERROR_BOUND = (3.0 + 16.0 * 0x1p-53) * 0x1p-53;

/* Parts that do not overlap, in growing size; their sum is the value. */
typedef struct expansion {
    double part[12];
    int parts;
} expansion;

static void add(expansion *e, double x) {
    for (int i = 0; i < e->parts; i++) {
        const double sum = e->part[i] + x;
        const double of_x = sum - e->part[i];
        e->part[i] = (e->part[i] - (sum - of_x)) + (x - of_x);
        x = sum;
    }
    e->part[e->parts++] = x;
}

static void add_product(expansion *e, double x, double y) {
    const double high = x * y;
    add(e, fma(x, y, -high));
    add(e, high);
}

static double exact(const double a[2], const double b[2], const double c[2]) {
    expansion e = {.parts = 0};
    add_product(&e, a[0], b[1]);
    add_product(&e, -a[1], b[0]);
    add_product(&e, b[0], c[1]);
    add_product(&e, -b[1], c[0]);
    add_product(&e, c[0], a[1]);
    add_product(&e, -c[1], a[0]);
    double sum = 0;
    for (int i = 0; i < e.parts; i++) {
        sum += e.part[i]; /* the greatest comes last and has the sign */
    }
    return sum;
}

double orient2(const double a[2], const double b[2], const double c[2]) {
    const double left = (a[0] - c[0]) * (b[1] - c[1]);
    const double right = (a[1] - c[1]) * (b[0] - c[0]);
    const double area = left - right;
    if (fabs(area) >= ERROR_BOUND * (fabs(left) + fabs(right))) {
        return area;
    }
    return exact(a, b, c);
}

double orient2_noise(double noise, const double a[2], const double b[2], const double c[2]) {
    double around = 6 * noise;
    for (int k = 0; k < 2; k++) {
        around += fabs(b[k] - a[k]) + fabs(c[k] - b[k]) + fabs(a[k] - c[k]);
    }
    return noise * around;
}
