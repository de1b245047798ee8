/* room_plant - a pot with a plant of long leaves
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#include "host_tools/scenes/room.h"

#define LEAVES 34u

typedef struct leaf {
    double length, half_wide, fall;
} leaf;

/* p[2] goes from the stem to the tip, which is blunt. */
static void as_leaf(const void *how, double p[3]) {
    const leaf *l = how;
    const double t = 0.5 * (p[2] + 1.0), wide = 0.06 + 1.9 * sqrt(t) * (1.0 - t);
    const double crease = 0.25 * l->half_wide * wide * p[0] * p[0];
    p[0] *= l->half_wide * wide;
    p[1] = 0.0015 * p[1] + crease - l->fall * t * t;
    p[2] = l->length * t * (1.0 - 0.25 * l->fall * t);
}

static void add_leaf(room *r, const place *earth, unsigned i) {
    const double age = room_random(r, 40, i), circles = 0.382 * i - (int)(0.382 * i);
    const leaf l = {0.35 + 0.3 * age, 0.035 + 0.02 * room_random(r, 41, i), 0.12 + 0.3 * age};
    const unsigned cells[3] = {2 * solid_divisions(&r->s, 2), 1, solid_divisions(&r->s, 12)};
    const place around = place_rotated(earth, 1, circles);
    const place rising = place_rotated(&around, 0, -0.21 + 0.15 * age);
    const place from = place_moved(&rising, 0.0, 0.0, 0.02 + 0.1 * (1.0 - age));
    solid_block(&r->s, &from, cells, as_leaf, &l);
}

void room_plant(room *r) {
    static const solid_point pot[] = {{0.0, -ROOM_INTO, 0}, {0.13, -ROOM_INTO, 0}, {0.18, 0.3, 1},
                                      {0.2, 0.31, 1},       {0.2, 0.35, 1},        {0.18, 0.355, 1},
                                      {0.165, 0.3, 0},      {0.0, 0.31, 0}};
    const place at = place_at(-ROOM_X + 0.55, 0.0, ROOM_Z - 0.85);
    const place earth = place_moved(&at, 0.0, 0.31, 0.0);
    solid_lathe(&r->s, &at, pot, sizeof pot / sizeof pot[0], 32);
    for (unsigned i = 0; i < LEAVES; i++) {
        add_leaf(r, &earth, i);
    }
}
