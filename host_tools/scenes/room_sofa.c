/* room_sofa - a sofa below the window, its cushions, and a rug
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#include "host_tools/scenes/noise.h"
#include "host_tools/scenes/room.h"

/* The rug's upper side: pile that is never even. */
static void as_rug(const void *how, double p[3]) {
    const double *half = how;
    const double x = half[0] * p[0], z = half[2] * p[2];
    const double pile = noise_gradient(24.0 * x + 0.3, 24.0 * z + 0.6, 11);
    const double waves = noise_gradient(1.7 * x + 0.2, 1.7 * z + 0.8, 12);
    p[1] = p[1] < 0.0 ? -ROOM_INTO : half[1] * (1.0 + 0.25 * pile + 0.6 * waves);
    p[0] = x;
    p[2] = z;
}

static void add_rug(room *r) {
    const place at = place_at(0.35, 0.0, 0.05), turned = place_rotated(&at, 1, 0.008);
    const double half[3] = {1.5, 0.012, 1.15};
    const unsigned n = solid_divisions(&r->s, 56), cells[3] = {n, 1, n};
    solid_block(&r->s, &turned, cells, as_rug, half);
    for (int k = 0; k < 2 * 76; k++) { /* the fringe */
        const double z = -1.12 + 0.03 * (k / 2), x = k & 1 ? 1.53 : -1.53;
        const place thread = place_moved(&turned, x, 0.004, z);
        const place lying =
            place_rotated(&thread, 1, 0.1 * (room_random(r, 30, (uint32_t)k) - 0.5));
        solid_box(&r->s, &lying, 0.035, 0.003, 0.005);
    }
}

typedef struct pillow {
    double half, thick;
} pillow;

/* Thick in the middle and thin at its edges, which curve inwards between the corners. */
static void as_pillow(const void *how, double p[3]) {
    const pillow *c = how;
    const double u = p[0], v = p[1], rise = (1.0 - u * u * u * u) * (1.0 - v * v * v * v);
    p[0] = c->half * u * (0.9 + 0.1 * v * v);
    p[1] = c->half * v * (0.9 + 0.1 * u * u);
    p[2] *= 0.006 + c->thick * sqrt(rise);
}

static void add_pillows(room *r, const place *seat) {
    const unsigned n = 2 * solid_divisions(&r->s, 8), cells[3] = {n, n, 1};
    for (unsigned i = 0; i < 3; i++) {
        const pillow c = {0.2 + 0.03 * room_random(r, 31, i), 0.06};
        const place low =
            place_moved(seat, -0.62 + 0.6 * i + 0.08 * room_random(r, 32, i), 0.27, -0.1);
        const place leaning = place_rotated(&low, 0, -0.05);
        const place at = place_rotated(&leaning, 2, 0.12 * (room_random(r, 33, i) - 0.5));
        solid_block(&r->s, &at, cells, as_pillow, &c);
    }
}

/* Its back is towards -z of its place. */
static void add_sofa(room *r) {
    const place wall = place_at(-ROOM_X + 0.62, 0.0, 0.1), at = place_rotated(&wall, 1, 0.25);
    const place seat = place_moved(&at, 0.0, 0.3, 0.0);
    const place back = place_moved(&at, 0.0, 0.56, -0.34), tilted = place_rotated(&back, 0, -0.02);
    solid_rounded(&r->s, &seat, (double[]){0.95, 0.12, 0.42}, 0.04);
    solid_rounded(&r->s, &tilted, (double[]){0.94, 0.3, 0.09}, 0.08);
    for (int side = -1; side <= 1; side += 2) {
        const place arm = place_moved(&at, side * 0.98, 0.4, 0.0);
        const place soft = place_moved(&at, side * 0.45, 0.45, 0.06);
        solid_rounded(&r->s, &arm, (double[]){0.1, 0.24, 0.43}, 0.09);
        solid_rounded(&r->s, &soft, (double[]){0.43, 0.08, 0.36}, 0.06);
        for (int end = -1; end <= 1; end += 2) {
            const place foot = place_moved(&at, side * 0.9, -ROOM_INTO, end * 0.34);
            solid_rod(&r->s, &foot, 0.025, 0.2, 14);
        }
    }
    const place on_seat = place_moved(&at, 0.0, 0.5, 0.0);
    add_pillows(r, &on_seat);
}

void room_sofa(room *r) {
    add_rug(r);
    add_sofa(r);
}
