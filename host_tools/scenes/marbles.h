/* marbles - the mechanics of scene_marbles
 *
 * The tray's slow lean rotates gravity; its own acceleration is left out.
 *
 * Invariants after every step: each centre is within MARBLES_REACH +
 * MARBLES_OVERLAP of the axis along all eight wall normals; no two centres
 * are nearer than 2 - MARBLES_OVERLAP. Tested, for the lean of the scene.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MARBLES_H
#define MARBLES_H
#include "host_tools/scenes/marbles_state.h"

#define MARBLES_STEPS 20u     /* per frame, 1/25 s */
#define MARBLES_GRAVITY 490.0 /* radii per second squared */

/* Frame 0: level, the first `count` of them, 1 .. MARBLES, rolling. */
void marbles_start(marbles *m, unsigned count);
void marbles_step(marbles *m);  /* 1/500 s with the lean as it is */
void marbles_frame(marbles *m); /* the next frame, leaning the tray */

#endif
