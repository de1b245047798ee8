/* room_dining - a table with turned legs, and four chairs
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/room.h"
#include "host_tools/scenes/room_table.h"

#define SEAT 0.45 /* high */

static void add_table(room *r) {
    static const solid_point leg[] = {
        {0.0, -ROOM_INTO, 0}, {0.022, -ROOM_INTO, 0}, {0.034, 0.05, 1}, {0.02, 0.10, 1},
        {0.036, 0.32, 1},     {0.028, 0.46, 1},       {0.040, 0.50, 1}, {0.024, 0.53, 1},
        {0.040, 0.56, 0},     {0.040, 0.73, 0},       {0.0, 0.73, 0}};
    const place top = place_moved(&room_table, 0.0, -0.02, 0.0);
    solid_rounded(&r->s, &top, (double[]){TABLE_X, 0.02, TABLE_Z}, 0.018);
    for (int k = 0; k < 4; k++) {
        const double x = (k & 1 ? 1.0 : -1.0) * (TABLE_X - 0.09);
        const double z = (k & 2 ? 1.0 : -1.0) * (TABLE_Z - 0.09);
        const place foot = place_moved(&room_table, x, -TABLE_HIGH, z);
        solid_lathe(&r->s, &foot, leg, sizeof leg / sizeof leg[0], 16);
    }
    for (int side = -1; side <= 1; side += 2) {
        const place along = place_moved(&room_table, 0.0, -0.085, side * (TABLE_Z - 0.09));
        const place across = place_moved(&room_table, side * (TABLE_X - 0.09), -0.085, 0.0);
        solid_box(&r->s, &along, TABLE_X - 0.1, 0.05, 0.012);
        solid_box(&r->s, &across, 0.012, 0.05, TABLE_Z - 0.1);
    }
}

/* A rail that is bent backwards in its middle. */
static void as_rail(const void *how, double p[3]) {
    const double *half = how;
    p[2] = half[2] * p[2] - 0.05 * (1.0 - p[0] * p[0]);
    p[1] = half[1] * (p[1] + (p[1] > 0.0 ? 0.5 * (1.0 - p[0] * p[0]) : 0.0));
    p[0] *= half[0];
}

static void add_back(room *r, const place *seat) {
    static const solid_point spindle[] = {{0.0, -0.01, 0}, {0.008, -0.01, 1}, {0.007, 0.1, 1},
                                          {0.014, 0.2, 1}, {0.007, 0.3, 1},   {0.008, 0.42, 0},
                                          {0.0, 0.42, 0}};
    const double half[3] = {0.2, 0.035, 0.012};
    const unsigned cells[3] = {solid_divisions(&r->s, 10), 2, 1};
    const place low = place_moved(seat, 0.0, 0.0, -0.18), back = place_rotated(&low, 0, -0.03);
    for (int i = -2; i <= 2; i++) {
        const double bent = -0.05 * (1.0 - i * i / 4.2);
        const place from = place_moved(&back, 0.085 * i, 0.0, 0.3 * bent);
        const place at = place_rotated(&from, 0, bent < -0.01 ? -0.012 : 0.0);
        solid_lathe(&r->s, &at, spindle, sizeof spindle / sizeof spindle[0], 10);
    }
    const place rail = place_moved(&back, 0.0, 0.44, 0.0);
    solid_block(&r->s, &rail, cells, as_rail, half);
}

/* `at` is the floor below the seat's middle; the back is at -z. */
static void add_chair(room *r, const place *at) {
    static const solid_point leg[] = {{0.0, -ROOM_INTO, 0}, {0.014, -ROOM_INTO, 1},
                                      {0.018, 0.12, 1},     {0.024, 0.3, 1},
                                      {0.016, SEAT, 0},     {0.0, SEAT, 0}};
    const place seat = place_moved(at, 0.0, SEAT, 0.0);
    solid_rounded(&r->s, &seat, (double[]){0.21, 0.022, 0.21}, 0.02);
    for (int k = 0; k < 4; k++) {
        const double x = k & 1 ? 0.17 : -0.17, z = k & 2 ? 0.17 : -0.17;
        const place foot = place_moved(at, x, 0.0, z);
        solid_lathe(&r->s, &foot, leg, sizeof leg / sizeof leg[0], 12);
    }
    for (int side = -1; side <= 1; side += 2) {
        const place from = place_moved(at, 0.17 * side, 0.2 + 0.02 * side, -0.17);
        const place rung = place_rotated(&from, 0, 0.25);
        solid_rod(&r->s, &rung, 0.009, 0.34, 10);
    }
    add_back(r, &seat);
}

/* Pushed up to the table, more or less; one is pulled out and turned. */
static void add_chairs(room *r) {
    static const double seats[4][3] = {
        {-0.38, -0.52, 0.0}, {0.38, -0.50, 0.0}, {-0.36, 0.60, 0.5}, {0.42, 0.56, 0.5}};
    for (unsigned i = 0; i < 4; i++) {
        const double out = i == 3 ? 0.3 : 0.12 * room_random(r, 4, i);
        const double turn = (i == 3 ? 0.16 : 0.05) * (room_random(r, 5, i) - 0.5);
        const double z = seats[i][1] + (seats[i][1] < 0.0 ? -out : out);
        const place floor = place_moved(&room_table, seats[i][0], -TABLE_HIGH, z);
        const place at = place_rotated(&floor, 1, seats[i][2] + turn);
        add_chair(r, &at);
    }
}

void room_dining(room *r) {
    add_table(r);
    add_chairs(r);
}
