/* triangle_record - four rays that may meet a triangle: which do, and their hits
 *
 * What triangle.c and triangle_lanes.c have in common; both give the same hits, bit for bit.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRIANGLE_RECORD_H
#define PLT_TRACE_TRIANGLE_RECORD_H

#include <string.h>

#include "engine/base/small_stack.h"
#include "engine/lanes/lane.h"
#include "engine/trace/exact.h"
#include "engine/trace/packet.h"
#include "engine/trace/triangle_edges.h"
#include "engine/trace/triangle_seldom.h"
#include "engine/tree/primitive_id.h"

/* Before functions for the few rays that single precision cannot decide: inlined, they take
 * registers from all the others, some 20 instructions per call on x86-64. */
#ifdef __GNUC__
#define RARELY __attribute__((noinline)) static
#else
#define RARELY static
#endif

/* A triangle that may be hit, and where the rays of a group pass it. */
typedef struct passing {
    const float (*corner)[3];
    float longest; /* at least the longest side of its box */
    uint32_t word;
    const plt_primitive_ids *ids;
    float normal[3];
    f4 numerator;    /* normal . (corner 0 - origin) */
    f4 enter, leave; /* t at which the rays are inside its own box, as boxes.c would say */
    m4 in_box;
} passing;

static plt_lone_ray ray_of(const plt_group_rays *g, int z, unsigned lane) {
    const plt_lone_ray ray = {{g->org[0][lane], g->org[1][lane], g->org[2][lane]},
                              {g->dir[0][lane], g->dir[1][lane], g->dir[2][lane]},
                              g->reach[lane],
                              z};
    return ray;
}

/* Is it a hit for the ray of a lane? If its edge functions are too coarse for u and v, it gets
 * others. */
RARELY int decide_lane(const passing *t, const plt_group_rays *g, edges *e, int z, unsigned lane,
                       float error) {
    const plt_lone_ray ray = ray_of(g, z, lane);
    plt_lone_edges lone;
    for (int c = 0; c < 3; c++) {
        lone.weight[c] = plt_lane(&e->weight[c], lane);
        lone.x[c] = plt_lane(&e->x[c], lane);
        lone.y[c] = plt_lane(&e->y[c], lane);
    }
    lone.error = error;
    const enum plt_meeting how = plt_decide_meeting(&ray, t->corner, &lone);
    if (how == PLT_MEETS_COARSELY) {
        plt_exact_weights(&ray, t->corner, lone.weight);
        for (int c = 0; c < 3; c++) {
            plt_lane_set(&e->weight[c], lane, lone.weight[c]);
        }
    }
    return how != PLT_MISSES;
}

/* Of the lanes that may be covered those that are. */
PLT_APART_ON_SMALL_STACKS static unsigned covered(const passing *t, const plt_group_rays *g,
                                                  edges *e, int z, unsigned candidates) {
    const f4 reach = f4_load(g->reach);
    const f4 extent = f4_max(larger3(f4_abs(e->x[0]), f4_abs(e->x[1]), f4_abs(e->x[2])),
                             larger3(f4_abs(e->y[0]), f4_abs(e->y[1]), f4_abs(e->y[2])));
    const f4 error = f4_mul(reach, f4_add(f4_mul(f4_all(32.0f * PLT_U), extent),
                                          f4_mul(f4_all(128.0f * PLT_U * PLT_U), reach)));
    const unsigned sure = m4_mask(m4_or(f4_lt(error, e->least), f4_lt(e->most, f4_neg(error))));
    unsigned hits = candidates & sure;
    for (unsigned lane = 0; (candidates & ~sure) >> lane != 0; lane++) {
        if ((candidates & ~sure) >> lane & 1u) {
            hits |= (unsigned)decide_lane(t, g, e, z, lane, plt_lane(&error, lane)) << lane;
        }
    }
    return hits;
}

/* n . dir over dir[z]: no factor is above 1, so no direction that is allowed overflows. */
static inline f4 normal_along(const float normal[3], const plt_group_rays *g, int z) {
    const int ax = plt_axis_after[z], ay = plt_axis_after[ax];
    return f4_add(f4_all(normal[z]), f4_add(f4_mul(f4_all(normal[ax]), f4_load(g->slope[0])),
                                            f4_mul(f4_all(normal[ay]), f4_load(g->slope[1]))));
}

/* normal . (corner 0 - origin). */
static inline f4 plane_numerator(const float corner[3], const float normal[3],
                                 const plt_group_rays *g) {
    f4 numerator = f4_zero();
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 p0 = f4_sub(f4_all(corner[a]), f4_load(g->org[a]));
        numerator = f4_add(numerator, f4_mul(f4_all(normal[a]), p0));
    }
    return numerator;
}

/* t = n . (p0 - org) / n . dir. */
static inline f4 plane_distance(f4 numerator, const plt_group_rays *g, int z, f4 along) {
    return f4_div(f4_div(numerator, along), f4_load(g->dir[z]));
}

/* `distance`, in `lanes` computed in integers. */
RARELY f4 exact_distance(const passing *t, const plt_group_rays *g, unsigned lanes, f4 distance) {
    float at[4];
    f4_store(at, distance);
    for (unsigned lane = 0; lanes >> lane != 0; lane++) {
        if (lanes >> lane & 1u) {
            const plt_lone_ray ray = ray_of(g, 0, lane);
            at[lane] = plt_exact_distance(t->corner, ray.org, ray.dir);
        }
    }
    return f4_min(f4_max(f4_load(at), t->enter), t->leave);
}

/* Lanes whose distance needs integers, if they are hit. Neither tmin nor tmax has a say: they
 * only spare lanes that are no hit anyway. A normal whose products may underflow is scaled, and
 * the distance computed anew. */
RARELY unsigned open_lanes(passing *t, const plt_group_slabs *s, const plt_group_rays *g, int z,
                           f4 *distance) {
    float scaled[3];
    const unsigned kind = plt_scale_normal(t->corner, t->normal, scaled);
    const f4 along = normal_along(scaled, g, z);
    if ((kind & PLT_NORMAL_IS_SMALL) != 0) {
        memcpy(t->normal, scaled, sizeof scaled);
        *distance = plane_distance(plane_numerator(t->corner[0], scaled, g), g, z, along);
    }
    unsigned open = 0;
    for (unsigned lane = 0; lane < 4; lane++) {
        const float from = plt_lane(&t->enter, lane), to = plt_lane(&t->leave, lane);
        const int is_open = plt_distance_is_open(plt_lane(&along, lane), kind, from, to);
        const int in_range = from <= s->tmax[lane] && s->tmin[lane] <= to;
        open |= (unsigned)(is_open && in_range) << lane;
    }
    return open;
}

static m4 nearer(const plt_group_slabs *s, const plt_group_rays *g, f4 t, u4 id) {
    const f4 tmax = f4_load(s->tmax);
    const m4 tie = m4_and(f4_eq(t, tmax), u4_lt(id, u4_load(g->id)));
    return m4_and(f4_le(f4_load(s->tmin), t), m4_or(f4_lt(t, tmax), tie));
}

#if !PLT_WITH_HULLS

/* u and v count from the corner that came first in the packed mesh. */
static void store_weights(plt_group_rays *g, m4 hit, const edges *e, uint32_t rotation) {
    const f4 sum = f4_add(f4_add(e->weight[0], e->weight[1]), e->weight[2]);
    const unsigned first = plt_axis_after[rotation], second = plt_axis_after[first];
    const f4 u = f4_min(f4_max(f4_div(e->weight[first], sum), f4_zero()), f4_all(1.0f));
    const f4 v = f4_min(f4_max(f4_div(e->weight[second], sum), f4_zero()), f4_all(1.0f));
    f4_store(g->u, f4_select(hit, u, f4_load(g->u)));
    f4_store(g->v, f4_select(hit, v, f4_load(g->v)));
}

/* Of `lanes` those whose hit would be nearer than what is known, and where; and of them those whose
 * distance needs integers. The normal may change, as a small one is scaled. */
PLT_APART_ON_SMALL_STACKS static unsigned near_lanes(passing *t, const plt_group_slabs *s,
                                                     const plt_group_rays *g, int z, unsigned lanes,
                                                     uint32_t id, f4 *at, unsigned *open) {
    const f4 along = normal_along(t->normal, g, z);
    f4 distance = plane_distance(t->numerator, g, z, along);
    const unsigned candidates = lanes & m4_mask(t->in_box);
    *open = 0;
    if (f4_min_lane(f4_abs(along)) < plt_open_limit(t->longest)) {
        *open = candidates & open_lanes(t, s, g, z, &distance);
    }
    /* A NaN (0 / 0) becomes `enter` by the rule of max. */
    *at = f4_min(f4_max(distance, t->enter), t->leave);
    return candidates & (m4_mask(nearer(s, g, *at, u4_all(id))) | *open);
}

PLT_APART_ON_SMALL_STACKS static void store_hits(const passing *t, plt_packet *p, unsigned index,
                                                 const edges *e, unsigned hits, f4 distance,
                                                 uint32_t word) {
    plt_group_slabs *s = &p->slabs.group[index];
    plt_group_rays *g = &p->rays[index];
    const m4 hit = m4_bits(hits);
    f4_store(s->tmax, f4_select(hit, p->any ? f4_all(-1.0f) : distance, f4_load(s->tmax)));
    u4_store(g->id, u4_select(hit, u4_all(plt_primitive_id(word)), u4_load(g->id)));
    if (!p->any) {
        PLT_UNROLLED for (int a = 0; a < 3; a++) {
            f4_store(g->normal[a], f4_select(hit, f4_all(t->normal[a]), f4_load(g->normal[a])));
        }
        store_weights(g, hit, e, plt_primitive_rotation(word));
    }
}

/* The rays of `lanes` are those that can meet the triangle; which is a hit? On small stacks in
 * three functions, as integers, in the second, need most of all. */
static inline unsigned record_passing(passing *t, plt_packet *p, unsigned index, edges *e, int z,
                                      unsigned lanes) {
    const plt_group_slabs *s = &p->slabs.group[index];
    const plt_group_rays *g = &p->rays[index];
    const uint32_t word = plt_primitive_word_find(t->ids, t->word), id = plt_primitive_id(word);
    f4 distance;
    unsigned open;
    const unsigned candidates = near_lanes(t, s, g, z, lanes, id, &distance, &open);
    if (candidates == 0) {
        return 0;
    }
    unsigned hits = covered(t, g, e, z, candidates);
    if ((hits & open) != 0) {
        distance = exact_distance(t, g, hits & open, distance);
        hits &= m4_mask(nearer(s, g, distance, u4_all(id)));
    }
    store_hits(t, p, index, e, hits, distance, word);
    return hits;
}

#endif

/* Any hit: a group whose rays have all hit something leaves the packet. */
static inline void retire_group(plt_packet *p, unsigned index) {
    const plt_group_slabs *s = &p->slabs.group[index];
    const unsigned seeking = m4_mask(f4_le(f4_load(s->tmin), f4_load(s->tmax)));
    p->active &= ~plt_mask_of(index, seeking == 0);
}

#endif
