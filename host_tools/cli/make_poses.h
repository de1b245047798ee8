/* make_poses - planelet make poses: frames of a mesh that goes from pose to pose
 *
 * SPDX-License-Identifier: MIT */
#ifndef MAKE_POSES_H
#define MAKE_POSES_H
#include "host_tools/base/fail.h"

/* Writes `frames` meshes, two or more, with their numbers for the '{}' in `pattern`, evenly spread
 * over the way from the first of `count` poses to the last. -1: `f` says which file is wrong. */
int make_poses(char *const *path, unsigned count, const char *pattern, unsigned frames, fail *f);

#endif
