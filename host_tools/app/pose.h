/* pose - a camera that is turned around what it looks at
 *
 * SPDX-License-Identifier: MIT */
#ifndef POSE_H
#define POSE_H

#include "engine/planelet.h"

typedef struct pose {
    plt_camera first;
    double azimuth, elevation; /* degrees from there; the eye goes to the right, and up */
    double nearer;             /* the distance is divided by it; 1 to begin with */
} pose;

void pose_begin(pose *p, const plt_camera *first);

/* Each returns whether the camera has changed: the eye stays clear of the axis, a degree at least,
 * and between a hundredth and twenty times its first distance. */
int pose_turn(pose *p, double azimuth, double elevation);
int pose_zoom(pose *p, double factor);

plt_camera pose_camera(const pose *p);

#endif
