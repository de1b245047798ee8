/* room_walls - the shell of the room and the timber on it
 *
 * The shell is solid: one box outside and a cavity within, without an opening.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/room.h"

#define THICK 0.2
#define BOARD 0.15 /* of the floor, wide */
#define BOARD_THICK 0.02
#define GAP 0.003 /* half of it */
#define BEAMS 5u

static void add_shell(room *r) {
    const double half = 0.5 * (ROOM_HIGH + BOARD_THICK);
    const place middle = place_at(0.0, 0.5 * (ROOM_HIGH - BOARD_THICK), 0.0);
    solid_box(&r->s, &middle, ROOM_X + THICK, half + THICK, ROOM_Z + THICK);
    r->s.is_hollow = 1;
    solid_box(&r->s, &middle, ROOM_X, half, ROOM_Z);
    r->s.is_hollow = 0;
}

/* Strips along x, each of boards that end where the seed says; what they lie on is the
 * cavity's lower side. */
static void add_floor(room *r) {
    const unsigned strips = (unsigned)(2.0 * ROOM_Z / BOARD);
    const double half = 0.5 * BOARD_THICK + 0.5 * ROOM_INTO;
    for (unsigned k = 0; k < strips; k++) {
        const double z = -ROOM_Z + (k + 0.5) * BOARD;
        double from = -ROOM_X - ROOM_INTO;
        for (unsigned i = 0; from < ROOM_X; i++) {
            const double length = 1.6 + 1.6 * room_random(r, 1, 8 * k + i);
            const double to = from + length > ROOM_X - 0.5 ? ROOM_X + ROOM_INTO : from + length;
            const place at = place_at(0.5 * (from + to), -half, z);
            solid_box(&r->s, &at, 0.5 * (to - from) - GAP, half, 0.5 * BOARD - GAP);
            from = to;
        }
    }
}

static void add_skirting(room *r) {
    const double high = 0.06, thick = 0.012, out = 0.5 * thick;
    for (int side = -1; side <= 1; side += 2) {
        const place along_x = place_at(0.0, high - ROOM_INTO, side * (ROOM_Z - out));
        const place along_z = place_at(side * (ROOM_X - out), high - ROOM_INTO, 0.0);
        solid_box(&r->s, &along_x, ROOM_X - 0.002, high, thick);
        solid_box(&r->s, &along_z, thick, high - 0.001, ROOM_Z - 0.003);
    }
}

static void add_beams(room *r) {
    const double half[3] = {0.07, 0.09, ROOM_Z + 0.03};
    for (unsigned i = 0; i < BEAMS; i++) {
        const place at = place_at(ROOM_X * (2.0 * (i + 0.5) / BEAMS - 1.0), ROOM_HIGH - 0.06, 0.0);
        solid_rounded(&r->s, &at, half, 0.02);
    }
}

void room_walls(room *r) {
    add_shell(r);
    add_floor(r);
    add_skirting(r);
    add_beams(r);
}
