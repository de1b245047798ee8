/* room_openings - a door, and a window behind a blind and curtains
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/cos_sin.h"
#include "host_tools/scenes/room.h"

#define SLATS 22u
#define WINDOW_HALF 0.75 /* wide */
#define WINDOW_LOW 0.95
#define WINDOW_HIGH 2.15

/* On the wall of -z: a leaf with four panels in a frame, and a knob. */
static void add_door(room *r) {
    const place at = place_at(1.75, 0.0, -ROOM_Z);
    const double panel[3] = {0.15, 0.36, 0.02}, knob[3] = {0.03, 0.03, 0.03};
    const place leaf = place_moved(&at, 0.0, 1.0, 0.0);
    solid_box(&r->s, &leaf, 0.42, 1.0, 0.03);
    for (int k = 0; k < 4; k++) {
        const place p = place_moved(&leaf, k & 1 ? 0.2 : -0.2, k & 2 ? 0.47 : -0.44, 0.028);
        solid_rounded(&r->s, &p, panel, 0.018);
    }
    for (int side = -1; side <= 1; side += 2) {
        const place post = place_moved(&at, side * 0.47, 1.02, 0.0);
        solid_box(&r->s, &post, 0.05, 1.03, 0.05);
    }
    const place lintel = place_moved(&at, 0.0, 2.08, 0.0);
    solid_box(&r->s, &lintel, 0.56, 0.06, 0.06);
    const place handle = place_moved(&leaf, -0.36, 0.0, 0.07);
    const place neck = place_rotated(&handle, 0, -0.25);
    solid_rod(&r->s, &neck, 0.012, 0.06, 12);
    solid_ball(&r->s, &handle, knob, 5);
}

/* Its own axes: x along the wall, z into the room. */
static place window_place(void) {
    const place at = place_at(-ROOM_X, 0.0, 0.1);
    return place_rotated(&at, 1, 0.25);
}

static void add_window(room *r) {
    const place at = window_place();
    const double middle = 0.5 * (WINDOW_LOW + WINDOW_HIGH), half = 0.5 * (WINDOW_HIGH - WINDOW_LOW);
    for (int i = -1; i <= 1; i++) {
        const place bar = place_moved(&at, i * WINDOW_HALF, middle, 0.0);
        solid_box(&r->s, &bar, 0.035, half + 0.034, 0.05);
    }
    const place head = place_moved(&at, 0.0, WINDOW_HIGH, 0.0);
    const place sill = place_moved(&at, 0.0, WINDOW_LOW, 0.05);
    for (int i = 1; i < 3; i++) {
        const place cross = place_moved(&at, 0.0, WINDOW_LOW + 0.4 * i, 0.0);
        solid_box(&r->s, &cross, WINDOW_HALF, 0.02, 0.04);
    }
    solid_box(&r->s, &head, WINDOW_HALF + 0.03, 0.035, 0.051);
    solid_rounded(&r->s, &sill, (double[]){WINDOW_HALF + 0.1, 0.025, 0.11}, 0.015);
}

static void add_blind(room *r) {
    const place at = window_place();
    for (unsigned i = 0; i < SLATS; i++) {
        const double y = WINDOW_HIGH - 0.06 - i * 0.034;
        const place hung = place_moved(&at, 0.0, y, 0.08);
        const place slat = place_rotated(&hung, 0, 0.08 + 0.02 * room_random(r, 2, i));
        solid_box(&r->s, &slat, WINDOW_HALF - 0.05, 0.0015, 0.02);
    }
    for (int side = -1; side <= 1; side += 2) {
        const place cord = place_moved(&at, side * 0.5, WINDOW_HIGH - 0.83, 0.08);
        solid_rod(&r->s, &cord, 0.003, 0.83, 8);
    }
}

typedef struct curtain {
    double half_wide, high, fold;
    unsigned folds;
} curtain;

/* Folds that get deeper downwards; the upper edge hangs from the rod. */
static void as_curtain(const void *how, double p[3]) {
    const curtain *c = how;
    const double along = 0.5 * (p[0] + 1.0), down = 0.5 * (1.0 - p[1]);
    const cos_sin wave = cos_sin_of((uint64_t)(along * c->folds * 65536.0), 65536);
    const cos_sin drift = cos_sin_of((uint64_t)((along + 0.3 * down) * 65536.0), 65536);
    const double depth = c->fold * (0.5 + 0.5 * down);
    p[0] = c->half_wide * p[0] * (0.93 + 0.07 * down);
    p[1] = -c->high * down;
    p[2] = 0.003 * p[2] + depth * wave.sine + 0.3 * depth * drift.cosine;
}

static void add_curtains(room *r) {
    const place at = window_place();
    const double high = 2.35;
    const unsigned cells[3] = {solid_divisions(&r->s, 48), solid_divisions(&r->s, 12), 1};
    for (int side = -1; side <= 1; side += 2) {
        const place hung = place_moved(&at, side * 1.0, high, 0.16);
        const curtain c = {0.27, high - 0.03, 0.035, side < 0 ? 7 : 8};
        const double end[3] = {0.035, 0.035, 0.035};
        const place ball = place_moved(&at, side * 1.4, high + 0.02, 0.16);
        solid_block(&r->s, &hung, cells, as_curtain, &c);
        solid_ball(&r->s, &ball, end, 5);
    }
    const place end = place_moved(&at, -1.4, high + 0.02, 0.16);
    const place rod = place_rotated(&end, 2, -0.25);
    solid_rod(&r->s, &rod, 0.015, 2.8, 12);
}

void room_openings(room *r) {
    add_door(r);
    add_window(r);
    add_blind(r);
    add_curtains(r);
}
