/* ray_block - one ray against four triangles
 *
 * triangle.c tests four rays against one triangle; here the other operand is the one that
 * all lanes share. The operations are the same on the same numbers in the same order, so t,
 * u, v and id are, too, bit for bit.
 *
 * Sources and bounds: triangle.h, triangle_common.h.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_RAY_BLOCK_H
#define PLT_TRACE_RAY_BLOCK_H

#include <string.h>

#include "engine/base/small_stack.h"
#include "engine/lanes/lanes.h"
#include "engine/planelet.h"
#include "engine/trace/triangle_common.h"
#include "engine/trace/wave_state.h"
#include "engine/tree/bvh4.h"

/* Edge functions of one ray past four triangles; as in triangle.c. */
typedef struct block_edges {
    f4 weight[3];
    f4 x[3], y[3]; /* sheared corners */
} block_edges;

/* Lanes that can be nearer than the hit so far, if the ray meets them: all that are, and few
 * that are not. */
unsigned plt_block_may_be_nearer(const plt_wave_ray *r, const plt_bvh4_block *b);

/* Keeps the nearest of the triangles in lanes `may` that the ray hits; 0: it hits none that is
 * nearer. For any hit, tmax becomes -1. */
int plt_block_hits(plt_wave_ray *r, const plt_bvh4_block *b, const plt_wave_job *job, unsigned may);

static inline f4 block_cross(f4 ax, f4 ay, f4 bx, f4 by) {
    return f4_sub(f4_mul(ax, by), f4_mul(ay, bx));
}

/* The origin, in the ray's own axes. */
static inline float own_org(const plt_wave_ray *r, int i) {
    float x;
    memcpy(&x, (const char *)r->org + r->at.axis[i], sizeof x);
    return x;
}

/* Lanes that the ray meets, or may meet. */
static inline unsigned plt_block_edges(const plt_wave_ray *r, const plt_bvh4_block *b,
                                       block_edges *e) {
    const f4 slope_x = f4_all(r->slope[0]), slope_y = f4_all(r->slope[1]);
    const f4 org_x = f4_all(own_org(r, 0)), org_y = f4_all(own_org(r, 1)),
             org_z = f4_all(own_org(r, 2));
    const char *corner = (const char *)b->corner;
    PLT_UNROLLED for (int c = 0; c < 3; c++, corner += sizeof b->corner[0]) {
        const f4 px = f4_load_16((const float *)(const void *)(corner + 4 * r->at.axis[0]));
        const f4 py = f4_load_16((const float *)(const void *)(corner + 4 * r->at.axis[1]));
        const f4 pz = f4_load_16((const float *)(const void *)(corner + 4 * r->at.axis[2]));
        const f4 depth = f4_sub(pz, org_z);
        e->x[c] = f4_sub(f4_sub(px, org_x), f4_mul(slope_x, depth));
        e->y[c] = f4_sub(f4_sub(py, org_y), f4_mul(slope_y, depth));
    }
    e->weight[0] = block_cross(e->x[2], e->y[2], e->x[1], e->y[1]);
    e->weight[1] = block_cross(e->x[0], e->y[0], e->x[2], e->y[2]);
    e->weight[2] = block_cross(e->x[1], e->y[1], e->x[0], e->y[0]);
    const f4 least = f4_min(f4_min(e->weight[0], e->weight[1]), e->weight[2]);
    const f4 most = f4_max(f4_max(e->weight[0], e->weight[1]), e->weight[2]);
    const f4 slack = f4_add(f4_mul(f4_load_16(b->longest), f4_all(72.0f * PLT_U * r->reach)),
                            f4_all(r->least_slack));
    return m4_mask(m4_or(f4_le(f4_neg(slack), least), f4_le(most, slack)));
}

/* Lanes that the ray may meet, nearer than the hit so far. */
PLT_APART_ON_SMALL_STACKS static unsigned plt_block_may_be_hit(const plt_wave_ray *r,
                                                               const plt_bvh4_block *b) {
    block_edges e;
    const unsigned met = plt_block_edges(r, b, &e);
    return met != 0 ? met & plt_block_may_be_nearer(r, b) : 0;
}

/* All three for one ray; 1: it has a nearer hit. */
static inline int plt_ray_block(plt_wave_ray *r, const plt_bvh4_block *b, const plt_wave_job *job) {
    const unsigned may = plt_block_may_be_hit(r, b);
    return may != 0 && plt_block_hits(r, b, job, may);
}

#endif
