/* quality - a finished tree made better, in passes over all its nodes
 *
 * A pass takes out every node in turn, the largest first, and puts it back where it is best
 * (reinsert.h). Passes go on while they gain 1/1000 of the cost, 20 at most. The result depends on
 * the tree alone, unless the time runs out.
 *
 * Memory: 72 bytes per node of list_tree, of which there are 2 per list less one, and a second
 * array of records; nothing else is allocated. Time: a pass is a search per node, of some 20
 * to 50 boxes where triangles are small; where all overlap it may be of all boxes, and the time
 * grows with the square of the triangles.
 *
 * With poses (poses.h) areas are those of all of them. Then the passes begin with a tree that was
 * split by all (pose_tree.h), or with the job's, if that costs less. Memory: 24 bytes more per pose
 * and node, of which there are at most two per triangle; before the passes 32 per pose and
 * triangle.
 *
 * SPDX-License-Identifier: MIT */
#ifndef QUALITY_H
#define QUALITY_H
#include "engine/builder/build.h"
#include "host_tools/pack/poses.h"

typedef struct quality_stats {
    uint32_t passes;
    uint32_t moves;       /* nodes that were moved, in all passes */
    uint32_t frames;      /* that it is to be good for: poses, the mesh's own among them */
    double before, after; /* list_tree_cost */
    double seconds;
    int out_of_time;
} quality_stats;

/* Improves what the job has built, for so many seconds at most; 0: as long as it takes. `p` NULL:
 * for the records as they are, and no more. The cost never gets worse. PLT_OK, or PLT_ERR_ARENA:
 * out of memory, and the records may be in another order. */
int quality_improve(plt_build_job *job, uint32_t seconds, const poses *p, quality_stats *stats);

/* The most bytes it takes for so many triangles, without poses. */
uint64_t quality_bytes(uint64_t triangles);

#endif
