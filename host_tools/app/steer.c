/* steer - see steer.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/steer.h"

static const double STEP = 7.5, NEARER = 1.15; /* degrees, a factor */

const char *const steer_names[STEER_ACTIONS] = {
    "turn left", "turn right", "turn up",        "turn down",
    "nearer",    "farther",    "the first view", "stop the frames, go on"};

static int reset(pose *p) {
    const plt_camera first = p->first;
    pose_begin(p, &first);
    return 1;
}

int steer(pose *p, enum steer_action action) {
    switch (action) {
    case STEER_LEFT:
        return pose_turn(p, -STEP, 0.0);
    case STEER_RIGHT:
        return pose_turn(p, STEP, 0.0);
    case STEER_UP:
        return pose_turn(p, 0.0, STEP);
    case STEER_DOWN:
        return pose_turn(p, 0.0, -STEP);
    case STEER_NEARER:
        return pose_zoom(p, NEARER);
    case STEER_FARTHER:
        return pose_zoom(p, 1.0 / NEARER);
    case STEER_RESET:
        return reset(p);
    default:
        return 0;
    }
}
