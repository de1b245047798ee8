/* triangle_plain - a triangle and a group of rays, without hulls: may they meet?
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRIANGLE_PLAIN_H
#define PLT_TRACE_TRIANGLE_PLAIN_H

#include "engine/trace/packet.h"
#include "engine/trace/triangle_common.h"
#include "engine/trace/triangle_corners.h"
#include "engine/trace/triangle_edges.h"

#if !PLT_WITH_HULLS

/* A number that all lanes have: once where lanes are memory, which is 120 bytes of stack less. */
#if PLT_LANES_REGISTERS
typedef f4 common;

static inline common common_of(float x) {
    return f4_all(x);
}

static inline f4 common_get(common x) {
    return x;
}
#else
typedef float common;

static inline common common_of(float x) {
    return x;
}

static inline f4 common_get(common x) {
    return f4_all(x);
}
#endif

/* A triangle made ready for all groups of a packet. */
typedef struct prepared {
    const plt_triangle *triangle;
    common from_org[3][3]; /* PER_PACKET: corner - origin, that axis last */
    common slack;          /* 72 u R L + 320 u^2 R^2; PER_GROUP: 72 u L */
} prepared;

static inline void prepare(prepared *t, const plt_packet *p, enum sharing sharing) {
    const plt_triangle *triangle = t->triangle;
    const float slack = 72.0f * PLT_U * triangle->longest;
    t->slack = common_of(slack);
    if (sharing == PER_GROUP) {
        return;
    }
    t->slack = common_of(slack * p->reach + p->least_slack);
    unsigned axis = plt_axis_after[p->axis];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        for (int c = 0; c < 3; c++) {
            t->from_org[c][a] = common_of(triangle->corner[c][axis] - p->org[axis]);
        }
        axis = plt_axis_after[axis];
    }
}

static inline f4 from_origin(const prepared *t, const plt_group_rays *g, int corner, int axis,
                             enum sharing sharing) {
    return sharing == PER_GROUP
               ? f4_sub(f4_all(t->triangle->corner[corner][axis]), f4_load(g->org[axis]))
               : common_get(t->from_org[corner][axis]);
}

/* The edge functions as seen along axis z. */
static inline edges edges_of(const prepared *t, const plt_group_rays *g, int z,
                             enum sharing sharing) {
    z = sharing == PER_PACKET ? 2 : z;
    const int ax = plt_axis_after[z], ay = plt_axis_after[ax];
    const f4 slope_x = f4_load(g->slope[0]), slope_y = f4_load(g->slope[1]);
    edges e;
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        const f4 depth = from_origin(t, g, c, z, sharing);
        e.x[c] = f4_sub(from_origin(t, g, c, ax, sharing), f4_mul(slope_x, depth));
        e.y[c] = f4_sub(from_origin(t, g, c, ay, sharing), f4_mul(slope_y, depth));
    }
    set_weights(&e);
    return e;
}

/* Lanes that the triangle covers, or may cover. */
static inline unsigned may_cover(const prepared *t, const plt_group_rays *g, const edges *e,
                                 enum sharing sharing) {
    f4 slack = common_get(t->slack);
    if (sharing == PER_GROUP) {
        slack = f4_add(f4_mul(slack, f4_load(g->reach)), f4_load(g->least_slack));
    }
    return m4_mask(m4_or(f4_le(f4_neg(slack), e->least), f4_le(e->most, slack)));
}

#endif

#endif
