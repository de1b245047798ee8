/* planes_lone - lone rays through trees of one axis per node, once for every layout
 *
 * Written against the nodes of an instance: a .c file that defines what is listed here, then
 * includes this header (bkd_trace.c, bih_trace.c).
 *
 *   PLANES_OUTER                1: both planes of a child are known; 0: the one that faces the
 *                               other child, and the other one is beyond all
 *   planes_node_root()          the root's link
 *   planes_node_is_leaf()       of a link
 *   planes_node_leaf()          of a leaf's link: the place of its first record
 *   planes_node_view()          of the link to an inner node, as a planes_view
 *
 * All but the first take the `nodes` of a planes_tracing.
 *
 * A ray keeps the interval that planes above have left of it, by the early distance to the plane
 * where it comes in and the late one to where it goes out; so no child is left out whose triangles
 * it may hit (lone_ray.h). The child on the side that the ray comes from is first.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_PLANES_LONE_H
#define BASELINES_PLANES_LONE_H

#include "host_tools/baselines/planes/planes_trace.h"
#include "host_tools/baselines/planes/planes_view.h"

/* What is left of a ray at a link. */
typedef struct planes_part {
    uint32_t link;
    float from, to;
} planes_part;

/* The root's part of a ray, by the box of all; 0: it has none. */
static int planes_begin(const lone_ray *r, const plt_box *box, uint32_t root, planes_part *p) {
    *p = (planes_part){root, r->tmin, r->tmax};
    for (int a = 0; a < 3; a++) {
        const float enter = lone_ray_early(r, a, r->negative[a] ? box->hi[a] : box->lo[a]);
        const float leave = lone_ray_late(r, a, r->negative[a] ? box->lo[a] : box->hi[a]);
        p->from = enter > p->from ? enter : p->from;
        p->to = leave < p->to ? leave : p->to;
    }
    return p->from <= p->to;
}

/* A child's part of a ray, for the child that is first along it or the other one. */
static inline planes_part planes_child_part(const lone_ray *r, const planes_view *v,
                                            const planes_part *p, int is_second) {
    const int axis = (int)v->axis, is_negative = r->negative[axis], c = is_second ^ is_negative;
    planes_part part = {v->link[c], p->from, p->to};
    if (PLANES_OUTER || is_second) {
        const float enter = lone_ray_early(r, axis, is_negative ? v->hi[c] : v->lo[c]);
        part.from = enter > part.from ? enter : part.from;
    }
    if (PLANES_OUTER || !is_second) {
        const float leave = lone_ray_late(r, axis, is_negative ? v->lo[c] : v->hi[c]);
        part.to = leave < part.to ? leave : part.to;
    }
    return part;
}

/* To a leaf, with what waits on the way on the stack; 0: no child is met before there is one. */
static int planes_descend(planes_tracing *t, const lone_ray *r, planes_part *p, planes_part *stack,
                          unsigned *entries) {
    while (!planes_node_is_leaf(t->nodes, p->link)) {
        const planes_view v = planes_node_view(t->nodes, p->link);
        const planes_part first = planes_child_part(r, &v, p, 0);
        const planes_part second = planes_child_part(r, &v, p, 1);
        const int meets_first = first.from <= first.to, meets_second = second.from <= second.to;
        t->counts.visits++;
        t->counts.planes += PLANES_OUTER ? 4 : 2;
        if (!meets_first && !meets_second) {
            return 0;
        }
        if (meets_first && meets_second) {
            stack[(*entries)++] = second;
        }
        *p = meets_first ? first : second;
    }
    return 1;
}

static void planes_trace_lone(planes_tracing *t, lone_ray *r) {
    planes_part stack[PLANES_DEPTH], p;
    unsigned entries = 0;
    if (!planes_begin(r, &t->box, planes_node_root(t->nodes), &p)) {
        return;
    }
    for (;;) {
        if (planes_descend(t, r, &p, stack, &entries)) {
            planes_leaf_meet(t, r, planes_node_leaf(t->nodes, p.link));
        }
        do { /* what begins behind the hit is of no use */
            if (entries == 0 || (t->any && r->id != PLT_MISS)) {
                return;
            }
            p = stack[--entries];
        } while (p.from > r->tmax);
        p.to = r->tmax < p.to ? r->tmax : p.to;
    }
}

#endif
