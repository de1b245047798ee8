/* room_toys - a chain of rings on a column, and balls that lie on the floor
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/cos_sin.h"
#include "host_tools/scenes/room.h"

#define BALLS 7u

typedef struct torus {
    double major, minor;
} torus;

static void add_column(room *r) {
    static const solid_point column[] = {
        {0.0, -ROOM_INTO, 0}, {0.19, -ROOM_INTO, 0}, {0.19, 0.08, 0}, {0.15, 0.1, 1},
        {0.12, 0.16, 0},      {0.10, 0.8, 0},        {0.11, 0.83, 1}, {0.16, 0.88, 0},
        {0.16, 0.94, 0},      {0.0, 0.94, 0}};
    static const solid_point egg[] = {{0.0, 0.0, 1},   {0.09, 0.05, 1}, {0.13, 0.16, 1},
                                      {0.10, 0.29, 1}, {0.04, 0.36, 1}, {0.0, 0.375, 0}};
    const place at = place_at(0.62, 0.0, -ROOM_Z + 0.35), top = place_moved(&at, 0.0, 0.935, 0.0);
    solid_lathe(&r->s, &at, column, sizeof column / sizeof column[0], 36);
    solid_lathe(&r->s, &top, egg, sizeof egg / sizeof egg[0], 48);
}

void room_toys(room *r) {
    static const double spots[BALLS][2] = {{1.55, 1.15}, {1.9, 0.55},    {-1.2, 1.45}, {-0.9, -1.5},
                                           {1.2, 1.6},   {-1.35, -0.95}, {2.2, -0.6}};
    add_column(r);
    for (unsigned i = 0; i < BALLS; i++) {
        const double size = 0.05 + 0.1 * room_random(r, 50, i);
        const double x = spots[i][0] + 0.2 * (room_random(r, 51, i) - 0.5);
        const double z = spots[i][1] + 0.2 * (room_random(r, 52, i) - 0.5);
        const place at = place_at(x, size - ROOM_INTO, z);
        const place turned = place_rotated(&at, 1, room_random(r, 53, i));
        solid_ball(&r->s, &turned, (double[]){size, size, size}, 10);
    }
}
