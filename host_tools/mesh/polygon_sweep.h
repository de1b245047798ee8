/* polygon_sweep - triangulates a simple outline in one pass from left to right
 *
 * SPDX-License-Identifier: MIT */
#ifndef POLYGON_SWEEP_H
#define POLYGON_SWEEP_H
#include <stddef.h>

#include "host_tools/mesh/polygon_order.h"

typedef struct sweep_event {
    double at[2];
    uint32_t corner;
} sweep_event;

/* A corner that can still be seen from the right. */
typedef struct sweep_link {
    uint32_t corner, lower, higher;
} sweep_link;

/* What is inside and just above an edge: a chain of links from the left end of that edge
 * to the left end of the next edge above. */
typedef struct sweep_gap {
    uint32_t lowest, highest, rightmost;
} sweep_gap;

/* Zero-initialised; grows; freed by polygon_sweep_free. */
typedef struct polygon_sweep {
    const double (*point)[2];
    uint32_t n;
    double noise;
    int crosses;
    sweep_event *event;
    order_edge *edge; /* edge i goes from corner i to the next */
    sweep_gap *gap;   /* of edges that have the inside above them */
    sweep_link *link;
    size_t room;
    polygon_order order;
    uint32_t links, triangles, *to;
    uint64_t work; /* steps of all searches, of all calls */
} polygon_sweep;

enum { SWEEP_NO_MEMORY = -1, SWEEP_CROSSES = 0, SWEEP_FILLED = 1, SWEEP_TOUCHES = 2 };

/* Triangulates an outline of n >= 3 points that turns left. It must not touch itself: then
 * `to` holds n - 2 triangles that turn left, none without area. Otherwise that is noticed,
 * and what `to` holds is worthless: SWEEP_CROSSES if it overlaps itself by more than
 * coordinates known to within `noise` can do by chance, or SWEEP_TOUCHES. O(n log n). */
int polygon_sweep_cut(polygon_sweep *s, const double (*point)[2], uint32_t n, double noise,
                      uint32_t *to);
void polygon_sweep_free(polygon_sweep *s);

#endif
