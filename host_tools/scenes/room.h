/* room - the parts of scene_room
 *
 * Metres; the floor is y = 0, the middle of the room x = z = 0. What stands, hangs or leans
 * reaches a little into what holds it: surfaces that lay in one plane would hide each other
 * by the numbers of their triangles.
 *
 * SPDX-License-Identifier: MIT */
#ifndef ROOM_H
#define ROOM_H
#include "host_tools/scenes/solids.h"

/* Half the room inside, and its height. */
#define ROOM_X 3.0
#define ROOM_Z 2.4
#define ROOM_HIGH 2.7
#define ROOM_INTO 0.004 /* how far a thing reaches into what holds it */

typedef struct room {
    solids s;
    uint32_t seed;
} room;

/* What can be drawn from the seed: 0 .. 1, one number for every pair. */
double room_random(const room *r, uint32_t what, uint32_t which);

void room_walls(room *r);     /* walls, floor, ceiling: two closed surfaces; and their timber */
void room_openings(room *r);  /* door, window, blind, curtains */
void room_pictures(room *r);  /* two reliefs in frames, a clock */
void room_dining(room *r);    /* table and chairs */
void room_tableware(room *r); /* what is on the table */
void room_shelf(room *r);     /* shelf with books */
void room_sofa(room *r);      /* sofa, cushions, rug */
void room_lamps(room *r);
void room_plant(room *r);
void room_toys(room *r); /* a knot on a column, balls on the floor */

#endif
