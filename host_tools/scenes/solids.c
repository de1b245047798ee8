/* solids - see solids.h: rotated profiles
 *
 * Source: Catmull and Rom, "A Class of Local Interpolating Splines", 1974.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/solids.h"

#include "host_tools/scenes/cos_sin.h"

#define SIDES_LEAST 6u
#define CURVE_STEPS 4u /* between two points of a profile, at a detail of 1 */

static double spline(const double p[4], double t) {
    const double a = 2.0 * p[1], b = p[2] - p[0];
    const double c = 2.0 * p[0] - 5.0 * p[1] + 4.0 * p[2] - p[3];
    const double d = 3.0 * (p[1] - p[2]) + p[3] - p[0];
    return 0.5 * (a + t * (b + t * (c + t * d)));
}

/* Of the curve from point i to the next; a straight neighbour does not bend it. */
static solid_point on_curve(const solid_point *profile, unsigned points, unsigned i, double t) {
    const unsigned before = i > 0 && profile[i - 1].is_curved ? i - 1 : i;
    const unsigned behind = i + 2 < points && profile[i + 1].is_curved ? i + 2 : i + 1;
    const solid_point *p[4] = {profile + before, profile + i, profile + i + 1, profile + behind};
    double radius[4], height[4];
    for (unsigned k = 0; k < 4; k++) {
        radius[k] = p[k]->radius;
        height[k] = p[k]->height;
    }
    return (solid_point){spline(radius, t), spline(height, t), 0};
}

static void add_ring(solids *s, const place *at, solid_point p, unsigned sides) {
    for (unsigned j = 0; j < sides; j++) {
        const cos_sin w = cos_sin_of(j, sides);
        const double local[3] = {p.radius * w.cosine, p.height, -p.radius * w.sine};
        solids_vertex(s, at, local);
    }
}

/* Both ends, and the rings between them in order. */
static void add_points(solids *s, const place *at, const solid_point *profile, unsigned points,
                       unsigned sides, unsigned steps) {
    const double below[3] = {0.0, profile[0].height, 0.0};
    const double above[3] = {0.0, profile[points - 1].height, 0.0};
    solids_vertex(s, at, below);
    solids_vertex(s, at, above);
    for (unsigned i = 0; i + 1 < points; i++) {
        const unsigned pieces = profile[i].is_curved ? steps : 1;
        for (unsigned k = i == 0; k < pieces; k++) {
            add_ring(s, at, k == 0 ? profile[i] : on_curve(profile, points, i, (double)k / pieces),
                     sides);
        }
    }
}

static void add_bands(solids *s, uint32_t first, unsigned rings, unsigned sides) {
    const uint32_t below = first, above = first + 1, ring = first + 2;
    for (uint32_t j = 0; j < sides; j++) {
        const uint32_t k = j + 1 < sides ? j + 1 : 0, last = ring + (rings - 1) * sides;
        solids_triangle(s, below, ring + k, ring + j);
        solids_triangle(s, above, last + j, last + k);
        for (uint32_t i = 0; i + 1 < rings; i++) {
            const uint32_t at = ring + i * sides;
            solids_quad(s, at + j, at + k, at + sides + k, at + sides + j);
        }
    }
}

void solid_lathe(solids *s, const place *at, const solid_point *profile, unsigned points,
                 unsigned sides) {
    const unsigned around = solid_divisions(s, sides), steps = solid_divisions(s, CURVE_STEPS);
    const unsigned n = around < SIDES_LEAST ? SIDES_LEAST : around;
    unsigned rings = 0;
    for (unsigned i = 0; i + 1 < points; i++) {
        rings += profile[i].is_curved ? steps : 1;
    }
    rings -= 1; /* the first point is no ring */
    if (!solids_only_count(s, (uint64_t)2 * n * rings)) {
        const uint32_t first = solids_first(s);
        add_points(s, at, profile, points, n, steps);
        add_bands(s, first, rings, n);
    }
}

void solid_rod(solids *s, const place *at, double radius, double height, unsigned sides) {
    const solid_point profile[] = {
        {0.0, 0.0, 0}, {radius, 0.0, 0}, {radius, height, 0}, {0.0, height, 0}};
    solid_lathe(s, at, profile, 4, sides);
}
