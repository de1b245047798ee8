/* played - the frames that an image holds, shown one after the other
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLAYED_H
#define PLAYED_H

#include "host_tools/app/frame_range.h"
#include "host_tools/app/scene.h"
#include "host_tools/base/fail.h"

/* -1, and says so, when the image of the scene, open, does not hold all of these frames. */
int played_refused(const scene *s, const char *path, const frame_range *range, fail *f);

/* All of the scene's engines show that frame. -1: `f` names the frame that could not be had; some
 * of the engines may show it. */
int played_to(const scene *s, const char *path, unsigned frame, fail *f);

/* Opens a scene whose frames, if the image has any, can be played: scene_open. With options.surface
 * its first frame is all that there is, as nothing moves. */
int played_open(scene *s, args *a, const char *path, fail *f);
/* Whether there are frames to play. */
int played_can(const scene *s);

#endif
