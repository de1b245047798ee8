/* polygon_plane - see polygon_plane.h
 *
 * Points are the corners moved along the normal into the coordinate plane that
 * it looks at most steeply. For a flat face this is an affine map, so what is
 * simple stays simple, and faces along two axes keep their coordinates exactly.
 * Source of the normal: M. Newell, in Sutherland, Sproull and Schumacker, "A
 * Characterization of Ten Hidden-Surface Algorithms", 1974.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/polygon_plane.h"

#include <math.h>
#include <string.h>

/* Below this part of the areas it is the sum of, a normal is rounding. */
static const double NO_AREA = 0x1p-40;
/* Smaller coordinates, in parts of the face, are 0: orient2 could not multiply them. */
static const double SMALLEST = 0x1p-400;

typedef struct view {
    const double *origin;
    double scale;     /* a power of 2: the face becomes about 1 in size */
    double normal[3]; /* of no particular length */
    double largest;   /* coordinate of a corner, in the file's scale */
} view;

static void look_at(const view *v, const double corner[3], double to[3]) {
    for (int a = 0; a < 3; a++) {
        to[a] = (corner[a] - v->origin[a]) * v->scale;
    }
}

static void measure(view *v, const double (*corner)[3], uint32_t n) {
    double size = 0;
    for (uint32_t i = 0; i < n; i++) {
        for (int a = 0; a < 3; a++) {
            v->largest = fmax(v->largest, fabs(corner[i][a]));
            size = fmax(size, fabs(corner[i][a] - v->origin[a]));
        }
    }
    int exponent;
    frexp(size, &exponent);
    v->scale = ldexp(1.0, exponent < -900 ? 900 : -exponent);
}

static double length_1(const double x[3]) {
    return fabs(x[0]) + fabs(x[1]) + fabs(x[2]);
}

/* The sum of the areas of the fan of corner 0; where they cancel, as in a path there and
 * back, the largest of them. */
static void find_normal(view *v, const double (*corner)[3], uint32_t n) {
    double all = 0, largest[3] = {0, 0, 0}, p[3], q[3];
    look_at(v, corner[1], p);
    for (uint32_t i = 2; i < n; i++) {
        look_at(v, corner[i], q);
        const double area[3] = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
                                p[0] * q[1] - p[1] * q[0]};
        const int is_largest = length_1(area) > length_1(largest);
        for (int a = 0; a < 3; a++) {
            v->normal[a] += area[a];
            largest[a] = is_largest ? area[a] : largest[a];
            p[a] = q[a];
        }
        all += length_1(area);
    }
    if (length_1(v->normal) <= NO_AREA * all) {
        memcpy(v->normal, largest, sizeof largest);
    }
}

static int steepest_axis(const double normal[3]) {
    int axis = 0;
    for (int a = 1; a < 3; a++) {
        axis = fabs(normal[a]) > fabs(normal[axis]) ? a : axis;
    }
    return axis;
}

/* To 24 bits, so that a float times it is exact in double. */
static double slope(double rise, double run) {
    return nearbyint(rise / run * 0x1p24) * 0x1p-24;
}

static double without_dust(double x) {
    return fabs(x) < SMALLEST ? 0 : x;
}

double polygon_project(const double (*corner)[3], uint32_t n, double (*to)[2]) {
    view v = {.origin = corner[0]};
    measure(&v, corner, n);
    find_normal(&v, corner, n);
    const int axis = steepest_axis(v.normal);
    if (!(fabs(v.normal[axis]) > 0)) {
        return -1;
    }
    const int is_behind = v.normal[axis] < 0;
    const int x = (axis + 1 + is_behind) % 3, y = (axis + 2 - is_behind) % 3;
    const double x_slope = slope(v.normal[x], v.normal[axis]);
    const double y_slope = slope(v.normal[y], v.normal[axis]);
    for (uint32_t i = 0; i < n; i++) {
        double p[3];
        look_at(&v, corner[i], p);
        to[i][0] = without_dust(p[x] - x_slope * p[axis]);
        to[i][1] = without_dust(p[y] - y_slope * p[axis]);
    }
    return 0x1p-23 * v.largest * v.scale; /* two coordinates meet in each of a point */
}
