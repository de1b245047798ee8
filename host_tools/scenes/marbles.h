/* marbles - the mechanics of scene_marbles
 *
 * In the tray's own axes: floor in the plane y = 0, marbles of radius 1 and
 * mass 1 whose centres stay at y = 1, lengths in radii (2 cm), seconds. The
 * tray's slow lean rotates gravity; its own acceleration is left out.
 *
 * Invariants after every step: each centre is within MARBLES_REACH +
 * MARBLES_OVERLAP of the axis along all eight wall normals; no two centres
 * are nearer than 2 - MARBLES_OVERLAP. Tested, for the lean of the scene.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MARBLES_H
#define MARBLES_H

#define MARBLES 109u
#define MARBLES_WALLS 8u
#define MARBLES_REACH 14.0   /* walls stand one radius further out */
#define MARBLES_OVERLAP 0.01 /* of a radius */
#define MARBLES_STEPS 20u    /* per frame, 1/25 s */
#define MARBLES_GRAVITY 490.0

typedef struct marble {
    double x, z, vx, vz;
    double spin[3];        /* radians per second */
    double orientation[4]; /* unit quaternion, real part first */
} marble;

typedef struct marbles {
    marble marble[MARBLES];
    unsigned frames;       /* simulated so far */
    double lean_x, lean_z; /* the tray's upward normal is (lean_x, ., lean_z) */
} marbles;

extern const double marbles_wall[MARBLES_WALLS][2]; /* outward normals, x z */

void marbles_start(marbles *m); /* frame 0: level, all rolling */
void marbles_step(marbles *m);  /* 1/500 s with the lean as it is */
void marbles_frame(marbles *m); /* the next frame, leaning the tray */

#endif
