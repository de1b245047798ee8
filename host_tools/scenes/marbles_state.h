/* marbles_state - the marbles of scene_marbles, and the tray they roll in
 *
 * In the tray's own axes: floor in the plane y = 0, marbles of radius 1 and
 * mass 1 whose centres stay at y = 1, lengths in radii (2 cm), seconds.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MARBLES_STATE_H
#define MARBLES_STATE_H

#define MARBLES 109u
#define MARBLES_WALLS 8u
#define MARBLES_REACH 14.0   /* walls stand one radius further out */
#define MARBLES_OVERLAP 0.01 /* of a radius */

typedef struct marble {
    double x, z, vx, vz;
    double spin[3];        /* radians per second */
    double orientation[4]; /* unit quaternion, real part first */
} marble;

typedef struct marbles {
    marble marble[MARBLES];
    unsigned count;        /* of them that are there, 1 .. MARBLES */
    unsigned frames;       /* simulated so far */
    double lean_x, lean_z; /* the tray's upward normal is (lean_x, ., lean_z) */
} marbles;

#endif
