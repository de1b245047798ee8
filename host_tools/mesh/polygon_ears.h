/* polygon_ears - cuts an outline into triangles that turn left
 *
 * SPDX-License-Identifier: MIT */
#ifndef POLYGON_EARS_H
#define POLYGON_EARS_H
#include "host_tools/mesh/polygon_tree.h"

/* A corner of what is left of the outline. */
typedef struct ears_corner {
    uint32_t before, after;
    uint32_t queued_after[2];             /* in either queue; itself: not there */
    uint32_t waits_for;                   /* the corner in the way of cutting this one */
    uint32_t waiter;                      /* first of those that wait for this one */
    uint32_t waiter_before, waiter_after; /* others that wait for the same */
    uint8_t is_cut, is_touched;           /* touched: a waiter depends on its neighbours */
} ears_corner;

/* Zero-initialised; grows; freed by polygon_ears_free. */
typedef struct polygon_ears {
    const double (*point)[2];
    double noise;
    ears_corner *corner;
    size_t room;
    polygon_tree tree; /* of corners that are not convex: only they can be in the way */
    uint32_t queue_first[2], queue_last[2]; /* of spikes, and of others */
    uint32_t left, some;
    int phase;
    uint32_t *to;
    uint64_t work, corners; /* tree nodes and corners looked at, and corners, of all calls */
} polygon_ears;

enum { EARS_NO_MEMORY = -1, EARS_LEFT = 0, EARS_ALL_CUT = 1, EARS_GIVEN_UP = 2 };

/* Cuts the outline of n >= 3 points into n - 2 triangles, none of them turned right by
 * more than orient2_noise. `to` receives them, corners in the outline's order, unless
 * it is NULL. EARS_LEFT when that does not come out; EARS_GIVEN_UP when
 * all calls together have taken 2^25 steps, and 160 for each of their corners. */
int polygon_ears_cut(polygon_ears *e, const double (*point)[2], uint32_t n, double noise,
                     uint32_t *to);
void polygon_ears_free(polygon_ears *e);

#endif
