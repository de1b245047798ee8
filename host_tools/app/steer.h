/* steer - what keys do to a camera, in a terminal and on a display
 *
 * SPDX-License-Identifier: MIT */
#ifndef STEER_H
#define STEER_H

#include "host_tools/app/pose.h"

/* The first eight are keys of the wire (enum wire_key), in its order. */
enum steer_action {
    STEER_LEFT, /* the eye goes there */
    STEER_RIGHT,
    STEER_UP,
    STEER_DOWN,
    STEER_NEARER,
    STEER_FARTHER,
    STEER_RESET, /* the first view again */
    STEER_STILL, /* stops the frames of a sequence, or lets them go on */
    STEER_ACTIONS
};

/* "turn left". */
extern const char *const steer_names[STEER_ACTIONS];

/* One press of a key; returns whether the camera has changed. STEER_STILL changes none. */
int steer(pose *p, enum steer_action action);

#endif
