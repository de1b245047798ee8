/* room_pictures - what hangs on the wall of -z: reliefs in frames, and a clock
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/noise.h"
#include "host_tools/scenes/room.h"

typedef struct relief {
    double half_wide, half_high, deep;
    uint32_t seed;
} relief;

/* Hills on the side of +z, which fall to 0 at the edges. */
static void as_relief(const void *how, double p[3]) {
    const relief *h = how;
    const double edge = (1.0 - p[0] * p[0]) * (1.0 - p[1] * p[1]);
    double x = 2.0 * p[0], y = 2.0 * p[1], share = 1.0, sum = 0.0;
    for (unsigned i = 0; i < 5; i++) {
        const double n = noise_gradient(x + 0.37, y + 0.71, h->seed + i);
        sum += share * (i == 0 ? n : n < 0.0 ? -n : n);
        share *= 0.5;
        x *= 2.03;
        y *= 2.03;
    }
    p[0] *= h->half_wide;
    p[1] *= h->half_high;
    p[2] = p[2] < 0.0 ? -0.01 : 0.01 + h->deep * edge * (0.6 + sum);
}

static void add_frame(room *r, const place *at, double half_wide, double half_high) {
    for (int side = -1; side <= 1; side += 2) {
        const place bar = place_moved(at, 0.0, side * half_high, 0.0);
        const place post = place_moved(at, side * half_wide, 0.0, 0.0);
        solid_rounded(&r->s, &bar, (double[]){half_wide + 0.04, 0.035, 0.04}, 0.015);
        solid_rounded(&r->s, &post, (double[]){0.034, half_high + 0.03, 0.038}, 0.015);
    }
}

static void add_picture(room *r, double x, double y, double half_wide, double half_high) {
    const place at = place_at(x, y, -ROOM_Z);
    const relief h = {half_wide, half_high, 0.07, r->seed + (uint32_t)(100.0 * (x + ROOM_X))};
    const unsigned n = solid_divisions(&r->s, 28), cells[3] = {n, n, 1};
    solid_block(&r->s, &at, cells, as_relief, &h);
    add_frame(r, &at, half_wide, half_high);
}

static void add_hand(room *r, const place *face, double circles, double half, double thick) {
    const place turned = place_rotated(face, 2, -circles);
    const place hand = place_moved(&turned, 0.0, half - 0.02, 0.05);
    solid_box(&r->s, &hand, thick, half, 0.004);
}

/* At some time of the day. */
static void add_clock(room *r, double x, double y) {
    const place face = place_at(x, y, -ROOM_Z), lying = place_rotated(&face, 0, 0.25);
    const solid_point rim[] = {{0.0, -0.01, 0},  {0.15, -0.01, 0}, {0.17, 0.02, 1},
                               {0.165, 0.05, 1}, {0.15, 0.055, 1}, {0.14, 0.04, 0},
                               {0.0, 0.04, 0}};
    const double time = room_random(r, 3, 0);
    solid_lathe(&r->s, &lying, rim, sizeof rim / sizeof rim[0], 32);
    for (int i = 0; i < 12; i++) {
        const place turned = place_rotated(&face, 2, i / 12.0);
        const place mark = place_moved(&turned, 0.0, 0.12, 0.04);
        solid_box(&r->s, &mark, i % 3 == 0 ? 0.006 : 0.003, 0.012, 0.004);
    }
    add_hand(r, &face, time, 0.045, 0.006);
    add_hand(r, &face, 12.0 * time - (int)(12.0 * time), 0.065, 0.004);
}

void room_pictures(room *r) {
    add_picture(r, 0.62, 1.66, 0.36, 0.26);
    add_picture(r, 2.6, 1.6, 0.2, 0.28);
    add_clock(r, -0.05, 2.1);
}
