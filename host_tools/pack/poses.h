/* poses - where a mesh's vertices are in other frames that its tree is to be good for, too
 *
 * The area of a node is then the mean of its boxes' areas in all poses, the mesh's own among them,
 * each as a share of the box of everything in that pose: T-SAH (Bittner and Meister, "T-SAH:
 * Animation Optimized Bounding Volume Hierarchies", 2015).
 *
 * SPDX-License-Identifier: MIT */
#ifndef POSES_H
#define POSES_H
#include "engine/base/box.h"
#include "host_tools/mesh/mesh.h"

#define POSES_MOST 7u /* beside the mesh's own */

typedef struct poses {
    const mesh *own; /* whose triangles they have */
    uint32_t count;
    float *vertex[POSES_MOST];     /* three per vertex; owned */
    double weight[POSES_MOST + 1]; /* of an area, the mesh's own first */
} poses;

/* How many to take of an animation of so many frames, the first of which is the mesh: all the
 * others, but POSES_MOST at most, and fewer of large meshes, as each takes some 100 bytes per
 * triangle to build a tree for. */
uint32_t poses_wanted(uint32_t frames, size_t triangles);
/* The frame of each of so many, evenly spread: 1 .. frames - 1, the last one among them. */
uint32_t poses_frame(uint32_t pose, uint32_t count, uint32_t frames);

/* `own` is to outlive it. */
void poses_begin(poses *p, const mesh *own);
/* One more, of as many vertices. -1: out of memory. */
int poses_add(poses *p, const mesh *frame);
/* When all are there, and are where they stay. */
void poses_weigh(poses *p);

plt_box poses_box(const poses *p, uint32_t pose, uint32_t triangle);

void poses_free(poses *p);

#endif
