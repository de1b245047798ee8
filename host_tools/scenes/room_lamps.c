/* room_lamps - a lamp above the table, and one that stands in a corner
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/room.h"
#include "host_tools/scenes/room_table.h"

#define POINTS(profile) (unsigned)(sizeof(profile) / sizeof(profile)[0])

static void add_hanging(room *r) {
    static const solid_point shade[] = {
        {0.0, 0.2, 0},  {0.03, 0.19, 1},   {0.07, 0.15, 1},  {0.2, 0.04, 1},  {0.215, 0.0, 1},
        {0.22, 0.0, 1}, {0.206, 0.045, 1}, {0.075, 0.16, 1}, {0.03, 0.22, 0}, {0.0, 0.22, 0}};
    const place at = place_moved(&room_table, 0.0, 0.78, 0.0);
    const place cord = place_moved(&at, 0.0, 0.21, 0.0), bulb = place_moved(&at, 0.0, 0.08, 0.0);
    const place rose = place_at(at.at[0], ROOM_HIGH - 0.04, at.at[2]);
    solid_lathe(&r->s, &at, shade, POINTS(shade), 40);
    solid_rod(&r->s, &cord, 0.006, ROOM_HIGH - cord.at[1] + 0.01, 10);
    solid_rod(&r->s, &rose, 0.05, 0.04 + ROOM_INTO, 24);
    solid_ball(&r->s, &bulb, (double[]){0.035, 0.045, 0.035}, 6);
}

static void add_standing(room *r) {
    static const solid_point foot[] = {
        {0.0, -ROOM_INTO, 0}, {0.16, -ROOM_INTO, 0}, {0.16, 0.015, 1}, {0.1, 0.03, 1},
        {0.02, 0.06, 1},      {0.014, 0.12, 0},      {0.012, 1.45, 0}, {0.0, 1.45, 0}};
    static const solid_point bulb[] = {
        {0.0, 1.43, 0}, {0.02, 1.43, 1}, {0.05, 1.52, 1}, {0.03, 1.58, 1}, {0.0, 1.6, 0}};
    const place at = place_at(-ROOM_X + 0.45, 0.0, -ROOM_Z + 0.4);
    const unsigned pleats = 48;
    solid_lathe(&r->s, &at, foot, POINTS(foot), 28);
    solid_lathe(&r->s, &at, bulb, POINTS(bulb), 20);
    for (unsigned i = 0; i < pleats; i++) {
        const place turned = place_rotated(&at, 1, (double)i / pleats);
        const place high = place_moved(&turned, 0.0, 1.56, 0.2);
        const place leaning = place_rotated(&high, 0, -0.05);
        const place pleat = place_rotated(&leaning, 1, i & 1 ? 0.06 : -0.06);
        solid_box(&r->s, &pleat, 0.0135, 0.15, 0.0015);
    }
}

void room_lamps(room *r) {
    add_hanging(r);
    add_standing(r);
}
