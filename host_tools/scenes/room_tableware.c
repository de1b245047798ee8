/* room_tableware - a bowl of fruit, a vase, a pot, cups and an open book
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/room.h"
#include "host_tools/scenes/room_table.h"

#define POINTS(profile) (unsigned)(sizeof(profile) / sizeof(profile)[0])

static void add_bowl(room *r) {
    static const solid_point bowl[] = {{0.0, -0.002, 0},  {0.06, -0.002, 0}, {0.06, 0.012, 1},
                                       {0.12, 0.04, 1},   {0.16, 0.1, 1},    {0.155, 0.102, 1},
                                       {0.112, 0.046, 1}, {0.05, 0.02, 1},   {0.0, 0.018, 0}};
    static const double fruit[6][3] = {{0.065, 0.07, 0.01},  {-0.03, 0.07, 0.062},
                                       {-0.05, 0.07, -0.04}, {0.03, 0.075, -0.066},
                                       {0.005, 0.13, 0.0},   {0.06, 0.13, 0.06}};
    const place at = place_moved(&room_table, 0.02, 0.0, 0.02);
    solid_lathe(&r->s, &at, bowl, POINTS(bowl), 40);
    for (unsigned i = 0; i < 6; i++) {
        const double size = 0.036 + 0.006 * room_random(r, 6, i);
        const double half[3] = {size, size * (0.88 + 0.2 * room_random(r, 7, i)), size};
        const place p = place_moved(&at, fruit[i][0], fruit[i][1], fruit[i][2]);
        solid_ball(&r->s, &p, half, 6);
    }
}

static void add_vase(room *r) {
    static const solid_point vase[] = {
        {0.0, -0.002, 0}, {0.045, -0.002, 1}, {0.085, 0.1, 1},  {0.07, 0.18, 1}, {0.03, 0.24, 1},
        {0.045, 0.29, 1}, {0.04, 0.288, 1},   {0.024, 0.24, 1}, {0.06, 0.18, 1}, {0.0, 0.1, 0}};
    const place at = place_moved(&room_table, -0.5, 0.0, -0.15);
    solid_lathe(&r->s, &at, vase, POINTS(vase), 36);
    for (unsigned i = 0; i < 9; i++) {
        const place turned = place_rotated(&at, 1, 0.38 * i - (int)(0.38 * i));
        const place from = place_moved(&turned, 0.0, 0.16, 0.0);
        const place stem = place_rotated(&from, 0, 0.015 + 0.045 * room_random(r, 8, i));
        const double high = 0.28 + 0.12 * room_random(r, 9, i);
        const place head = place_moved(&stem, 0.0, high, 0.0);
        solid_rod(&r->s, &stem, 0.003, high, 6);
        solid_ball(&r->s, &head, (double[]){0.028, 0.02, 0.028}, 4);
    }
}

static void add_pot(room *r) {
    static const solid_point pot[] = {{0.0, -0.002, 0}, {0.05, -0.002, 1}, {0.09, 0.06, 1},
                                      {0.05, 0.125, 1}, {0.035, 0.13, 1},  {0.015, 0.14, 1},
                                      {0.018, 0.16, 1}, {0.0, 0.168, 0}};
    const place at = place_moved(&room_table, 0.42, 0.0, -0.12);
    const place side = place_moved(&at, 0.07, 0.06, 0.0), spout = place_rotated(&side, 2, -0.12);
    solid_lathe(&r->s, &at, pot, POINTS(pot), 36);
    solid_rod(&r->s, &spout, 0.012, 0.1, 14);
    for (int i = 0; i < 9; i++) { /* the handle: beads on half a circle */
        const place arm = place_moved(&at, -0.075, 0.065, 0.0);
        const place turned = place_rotated(&arm, 2, 0.05 + 0.05 * i);
        const place bead = place_moved(&turned, 0.0, 0.045, 0.0);
        solid_ball(&r->s, &bead, (double[]){0.012, 0.009, 0.009}, 3);
    }
}

static void add_cups(room *r) {
    static const solid_point saucer[] = {{0.0, -0.002, 0}, {0.04, -0.002, 1}, {0.075, 0.014, 1},
                                         {0.07, 0.016, 1}, {0.035, 0.006, 0}, {0.0, 0.006, 0}};
    static const solid_point cup[] = {{0.0, 0.004, 0},   {0.02, 0.004, 1},  {0.036, 0.03, 1},
                                      {0.042, 0.065, 1}, {0.039, 0.066, 1}, {0.032, 0.03, 1},
                                      {0.0, 0.015, 0}};
    for (unsigned i = 0; i < 3; i++) {
        const double x = -0.3 + 0.33 * i + 0.06 * room_random(r, 10, i);
        const double z = (i == 1 ? -0.29 : 0.28) + 0.05 * room_random(r, 11, i);
        const place at = place_moved(&room_table, x, 0.0, z);
        solid_lathe(&r->s, &at, saucer, POINTS(saucer), 28);
        solid_lathe(&r->s, &at, cup, POINTS(cup), 28);
    }
}

/* Pages that rise from the spine and fall to the edge: p[0] goes outwards. */
static void as_pages(const void *how, double p[3]) {
    const double *half = how, out = 0.5 * (p[0] + 1.0);
    const double high = half[1] * (0.35 + 4.0 * out * (1.0 - out) * (1.0 - 0.4 * out));
    p[0] = 2.0 * half[0] * out + 0.001;
    p[1] = p[1] > 0.0 ? 0.006 + high : 0.002;
    p[2] *= half[2];
}

static void add_open_book(room *r) {
    const place lying = place_moved(&room_table, 0.5, 0.0, 0.2);
    const place at = place_rotated(&lying, 1, 0.1 * room_random(r, 12, 0));
    const double half[3] = {0.07, 0.012, 0.1};
    const unsigned cells[3] = {solid_divisions(&r->s, 10), 1, 1};
    for (int side = 0; side < 2; side++) {
        const place page = place_rotated(&at, 1, side ? 0.5 : 0.0);
        const place cover = place_moved(&page, 0.074, 0.002, 0.0);
        solid_block(&r->s, &page, cells, as_pages, half);
        solid_box(&r->s, &cover, 0.074, 0.003, 0.105);
    }
}

void room_tableware(room *r) {
    add_bowl(r);
    add_vase(r);
    add_pot(r);
    add_cups(r);
    add_open_book(r);
}
