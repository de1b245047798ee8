/* solids_block - see solids.h: the surface of a block of cells, in any shape
 *
 * Vertices are in layers along axis 2. The first and the last layer are whole grids, those
 * between them their outlines.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#include "host_tools/scenes/solids.h"

#define ROUNDED_MOST 6u /* divisions of a rounded edge: more would be slivers */

/* Of the vertex at the corner i of the cells, which is on the surface. */
static uint32_t index_of(const unsigned n[3], const unsigned i[3]) {
    const uint32_t grid = (n[0] + 1) * (n[1] + 1), outline = 2 * (n[0] + n[1]);
    if (i[2] == 0 || i[2] == n[2]) {
        return (i[2] == 0 ? 0 : grid + (n[2] - 1) * outline) + i[1] * (n[0] + 1) + i[0];
    }
    const uint32_t layer = grid + (i[2] - 1) * outline;
    if (i[1] == 0 || i[1] == n[1]) {
        return layer + (i[1] == 0 ? 0 : n[0] + 1) + i[0];
    }
    return layer + 2 * (n[0] + 1) + 2 * (i[1] - 1) + (i[0] > 0);
}

static void add_corner(solids *s, const place *at, const unsigned n[3], const unsigned i[3],
                       solid_shape shape, const void *how) {
    double p[3];
    for (unsigned a = 0; a < 3; a++) {
        p[a] = 2.0 * i[a] / n[a] - 1.0;
    }
    shape(how, p);
    solids_vertex(s, at, p);
}

/* A grid, or its outline: first two whole rows, then the ends of those between. */
static void add_layer(solids *s, const place *at, const unsigned n[3], unsigned layer,
                      solid_shape shape, const void *how) {
    const int is_grid = layer == 0 || layer == n[2];
    const unsigned rows = is_grid ? n[1] : 1;
    for (unsigned j = 0; j <= rows; j++) {
        for (unsigned i = 0; i <= n[0]; i++) {
            add_corner(s, at, n, (unsigned[]){i, is_grid ? j : j * n[1], layer}, shape, how);
        }
    }
    for (unsigned j = 1; j < n[1] && !is_grid; j++) {
        add_corner(s, at, n, (unsigned[]){0, j, layer}, shape, how);
        add_corner(s, at, n, (unsigned[]){n[0], j, layer}, shape, how);
    }
}

/* The side at `end` (0 or n) of axis a. */
static void add_side(solids *s, uint32_t first, const unsigned n[3], unsigned a, unsigned end) {
    const unsigned b = (a + 1) % 3, c = (a + 2) % 3;
    for (unsigned j = 0; j < n[c]; j++) {
        for (unsigned i = 0; i < n[b]; i++) {
            uint32_t q[4];
            for (unsigned k = 0; k < 4; k++) { /* counter-clockwise, seen from above the axis */
                unsigned corner[3];
                corner[a] = end;
                corner[b] = i + (k == 1 || k == 2);
                corner[c] = j + (k >= 2);
                q[k] = first + index_of(n, corner);
            }
            if (end > 0) {
                solids_quad(s, q[0], q[1], q[2], q[3]);
            } else {
                solids_quad(s, q[0], q[3], q[2], q[1]);
            }
        }
    }
}

void solid_block(solids *s, const place *at, const unsigned cells[3], solid_shape shape,
                 const void *how) {
    const uint64_t x = cells[0], y = cells[1], z = cells[2];
    if (solids_only_count(s, 4 * (x * y + y * z + z * x))) {
        return;
    }
    const uint32_t first = solids_first(s);
    for (unsigned layer = 0; layer <= cells[2]; layer++) {
        add_layer(s, at, cells, layer, shape, how);
    }
    for (unsigned a = 0; a < 3; a++) {
        add_side(s, first, cells, a, 0);
        add_side(s, first, cells, a, cells[a]);
    }
}

/* ---- shapes --------------------------------------------------------------- */

static void as_box(const void *how, double p[3]) {
    const double *half = how;
    for (unsigned a = 0; a < 3; a++) {
        p[a] *= half[a];
    }
}

void solid_box(solids *s, const place *at, double half_x, double half_y, double half_z) {
    const double half[3] = {half_x, half_y, half_z};
    const unsigned cells[3] = {1, 1, 1};
    solid_block(s, at, cells, as_box, half);
}

/* About tan(pi/4 x): cells of a cube's side are then about of one size on the ball. */
static double even(double x) {
    return x * (0.77 + 0.23 * x * x);
}

static void as_ball(const void *how, double p[3]) {
    const double *half = how;
    double square = 0.0;
    for (unsigned a = 0; a < 3; a++) {
        p[a] = even(p[a]);
        square += p[a] * p[a];
    }
    for (unsigned a = 0; a < 3; a++) {
        p[a] *= half[a] / sqrt(square);
    }
}

void solid_ball(solids *s, const place *at, const double half[3], unsigned divisions) {
    const unsigned n = 2 * solid_divisions(s, divisions), cells[3] = {n, n, n};
    solid_block(s, at, cells, as_ball, half);
}

typedef struct rounding {
    const double *half;
    double radius;
    double inner; /* share of a side that is not rounded, in the block's own coordinates */
} rounding;

/* The outer cells are as wide as the radius; their corners move onto a sphere. */
static void as_rounded(const void *how, double p[3]) {
    const rounding *r = how;
    double beyond[3], square = 0.0;
    for (unsigned a = 0; a < 3; a++) {
        const double flat = r->half[a] - r->radius, t = fabs(p[a]), sign = p[a] < 0.0 ? -1.0 : 1.0;
        const int is_inner = t <= r->inner * 1.000001;
        beyond[a] = is_inner ? 0.0 : sign * r->radius * (t - r->inner) / (1.0 - r->inner);
        p[a] = is_inner ? flat * p[a] / r->inner : sign * flat;
        square += beyond[a] * beyond[a];
    }
    const double scale = square > 0.0 ? r->radius / sqrt(square) : 0.0;
    for (unsigned a = 0; a < 3; a++) {
        p[a] += scale * beyond[a];
    }
}

void solid_rounded(solids *s, const place *at, const double half[3], double radius) {
    const unsigned asked = solid_divisions(s, 2);
    const unsigned edge = asked > ROUNDED_MOST ? ROUNDED_MOST : asked;
    const unsigned n = 2 * edge + 1, cells[3] = {n, n, n};
    const rounding r = {half, radius, 1.0 / n};
    solid_block(s, at, cells, as_rounded, &r);
}
