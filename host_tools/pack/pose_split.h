/* pose_split - one range of triangles into two, by binned SAH over the boxes of all poses
 *
 * Planes are looked for along the axes of some of the poses, as triangles that move apart can be
 * told apart only where they are; what a plane costs is the sum over all of them.
 *
 * SPDX-License-Identifier: MIT */
#ifndef POSE_SPLIT_H
#define POSE_SPLIT_H
#include "engine/builder/build.h"
#include "engine/lanes/lanes.h"
#include "host_tools/pack/poses.h"

enum { POSE_SPLIT_BINS = 16, POSE_SPLIT_BOXES = POSES_MOST + 1 };

/* In lanes x y z and one that means nothing. */
typedef struct pose_box {
    f4 lo, hi;
} pose_box;

typedef struct pose_split {
    uint32_t boxes;       /* per triangle: the mesh's own, then one per pose */
    const double *weight; /* of their areas */
    pose_box *box;        /* of the triangles; owned */
    uint32_t *order;      /* of the triangles, as ranges are split; owned */
    pose_box bin[POSE_SPLIT_BINS][POSE_SPLIT_BOXES];
    uint32_t count[POSE_SPLIT_BINS];
} pose_split;

/* Of the job's records, numbered as they lie, in that order. -1: out of memory; to be freed in any
 * case. */
int pose_split_begin(pose_split *s, const plt_build_job *job, const poses *p);

/* Permutes `order` so that [begin, middle) and [middle, end) are the two; returns the middle. Of at
 * least two triangles. The same every time. */
uint32_t pose_split_range(pose_split *s, uint32_t begin, uint32_t end);

void pose_split_free(pose_split *s);

#endif
