/* planes_axis - across which axis a node's planes stand
 *
 * A ray that has come to a node is in the box that the planes above have left of the scene's, not
 * in the tight one of its triangles. The axis is the one that leaves its children least of that,
 * each counted with its triangles: the surface area heuristic for boxes of which one axis is cut.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_PLANES_AXIS_H
#define BASELINES_PLANES_AXIS_H

#include "host_tools/baselines/base/binary_tree.h"

/* What nodes of one axis are made from. */
typedef struct planes_source {
    binary_tree *tree; /* its boxes become, top down, what the planes above leave of the scene's */
    float *weight;     /* triangles below each of its nodes */
    int outer;         /* 1: both planes of a child are told; 0: the one that faces the other */
} planes_source;

/* -1: no memory. */
int planes_source_begin(planes_source *s, binary_tree *tree, int outer);
void planes_source_end(planes_source *s);

typedef struct planes_cut {
    uint32_t axis;
    float lo[2], hi[2]; /* of both children along it */
} planes_cut;

/* The axis of an inner node whose parents have been asked for. Its children's boxes become what is
 * left for them, and the one with the lower centre becomes the first. */
planes_cut planes_source_cut(planes_source *s, uint32_t node);

#endif
