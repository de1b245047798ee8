/* triangle_edges - the edge functions of four rays and a triangle
 *
 * Source: Woop, Benthin, Wald, "Watertight ray/triangle intersection", 2013.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRIANGLE_EDGES_H
#define PLT_TRACE_TRIANGLE_EDGES_H

#include "engine/lanes/lanes.h"

/* What is computed once per packet: corner - origin, for one origin and one axis of the
 * shear; or nothing. (One origin alone is rare, and was not worth its code.) */
enum sharing { PER_GROUP, PER_PACKET };

/* The edge functions of four rays; each is twice a signed area. */
typedef struct edges {
    f4 weight[3];   /* of each corner: the function of the edge across from it */
    f4 least, most; /* of the three */
    f4 x[3], y[3];  /* sheared corners */
} edges;

static inline f4 cross(f4 ax, f4 ay, f4 bx, f4 by) {
    return f4_sub(f4_mul(ax, by), f4_mul(ay, bx));
}

static inline f4 larger3(f4 a, f4 b, f4 c) {
    return f4_max(f4_max(a, b), c);
}

/* Edge functions of the sheared corners. */
static inline void set_weights(edges *e) {
    e->weight[0] = cross(e->x[2], e->y[2], e->x[1], e->y[1]);
    e->weight[1] = cross(e->x[0], e->y[0], e->x[2], e->y[2]);
    e->weight[2] = cross(e->x[1], e->y[1], e->x[0], e->y[0]);
    e->least = f4_min(f4_min(e->weight[0], e->weight[1]), e->weight[2]);
    e->most = larger3(e->weight[0], e->weight[1], e->weight[2]);
}

#endif
