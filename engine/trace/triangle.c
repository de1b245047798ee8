/* triangle - see triangle.h
 *
 * Error bounds: triangle_common.h.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/triangle.h"

#include <string.h>

#include "engine/base/small_stack.h"
#include "engine/trace/exact.h"
#include "engine/trace/triangle_seldom.h"

/* Before functions for the few rays that single precision cannot decide: inlined, they take
 * registers from all the others, some 20 instructions per call on x86-64. */
#ifdef __GNUC__
#define RARELY __attribute__((noinline)) static
#else
#define RARELY static
#endif

/* What is computed once per packet: corner - origin, for one origin and one axis of the
 * shear; or nothing. (One origin alone is rare, and was not worth its code.) */
enum sharing { PER_GROUP, PER_PACKET };

/* A triangle made ready for all groups of a packet. */
typedef struct prepared {
    const plt_triangle *triangle;
    f4 from_org[3][3]; /* PER_PACKET: corner - origin, in all lanes, that axis last */
    f4 slack;          /* 72 u R L + 320 u^2 R^2; PER_GROUP: 72 u L */
} prepared;

/* The edge functions of four rays; each is twice a signed area. */
typedef struct edges {
    f4 weight[3];   /* of each corner: the function of the edge across from it */
    f4 least, most; /* of the three */
    f4 x[3], y[3];  /* sheared corners */
} edges;

static inline void prepare(prepared *t, const plt_packet *p, enum sharing sharing) {
    const plt_triangle *triangle = t->triangle;
    t->slack = f4_all(72.0f * PLT_U * triangle->longest);
    if (sharing == PER_GROUP) {
        return;
    }
    t->slack = f4_add(f4_mul(t->slack, f4_all(p->reach)), f4_all(p->least_slack));
    unsigned axis = plt_axis_after[p->axis];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        for (int c = 0; c < 3; c++) {
            t->from_org[c][a] = f4_all(triangle->corner[c][axis] - p->org[axis]);
        }
        axis = plt_axis_after[axis];
    }
}

static inline f4 from_origin(const prepared *t, const plt_group_rays *g, int corner, int axis,
                             enum sharing sharing) {
    return sharing == PER_GROUP
               ? f4_sub(f4_all(t->triangle->corner[corner][axis]), f4_load(g->org[axis]))
               : t->from_org[corner][axis];
}

static inline f4 cross(f4 ax, f4 ay, f4 bx, f4 by) {
    return f4_sub(f4_mul(ax, by), f4_mul(ay, bx));
}

static inline f4 larger3(f4 a, f4 b, f4 c) {
    return f4_max(f4_max(a, b), c);
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
    e.weight[0] = cross(e.x[2], e.y[2], e.x[1], e.y[1]);
    e.weight[1] = cross(e.x[0], e.y[0], e.x[2], e.y[2]);
    e.weight[2] = cross(e.x[1], e.y[1], e.x[0], e.y[0]);
    e.least = f4_min(f4_min(e.weight[0], e.weight[1]), e.weight[2]);
    e.most = larger3(e.weight[0], e.weight[1], e.weight[2]);
    return e;
}

/* Lanes that the triangle covers, or may cover. */
static inline unsigned may_cover(const prepared *t, const plt_group_rays *g, const edges *e,
                                 enum sharing sharing) {
    f4 slack = t->slack;
    if (sharing == PER_GROUP) {
        slack = f4_add(f4_mul(slack, f4_load(g->reach)), f4_load(g->least_slack));
    }
    return m4_mask(m4_or(f4_le(f4_neg(slack), e->least), f4_le(e->most, slack)));
}

static float lane_of(f4 v, unsigned lane) {
    float all[4];
    f4_store(all, v);
    return all[lane];
}

static void set_lane(f4 *v, unsigned lane, float to) {
    float all[4];
    f4_store(all, *v);
    all[lane] = to;
    *v = f4_load(all);
}

static plt_lone_ray ray_of(const plt_group_rays *g, int z, unsigned lane) {
    const plt_lone_ray ray = {{g->org[0][lane], g->org[1][lane], g->org[2][lane]},
                              {g->dir[0][lane], g->dir[1][lane], g->dir[2][lane]},
                              g->reach[lane],
                              z};
    return ray;
}

/* Is it a hit for the ray of a lane? If its edge functions are too coarse for u and v, it gets
 * others. */
RARELY int decide_lane(const prepared *t, const plt_group_rays *g, edges *e, int z, unsigned lane,
                       float error) {
    const plt_lone_ray ray = ray_of(g, z, lane);
    plt_lone_edges lone;
    for (int c = 0; c < 3; c++) {
        lone.weight[c] = lane_of(e->weight[c], lane);
        lone.x[c] = lane_of(e->x[c], lane);
        lone.y[c] = lane_of(e->y[c], lane);
    }
    lone.error = error;
    const enum plt_meeting how = plt_decide_meeting(&ray, t->triangle->corner, &lone);
    if (how == PLT_MEETS_COARSELY) {
        plt_exact_weights(&ray, t->triangle->corner, lone.weight);
        for (int c = 0; c < 3; c++) {
            set_lane(&e->weight[c], lane, lone.weight[c]);
        }
    }
    return how != PLT_MISSES;
}

/* Of the lanes that may be covered those that are. */
static unsigned covered(const prepared *t, const plt_group_rays *g, edges *e, int z,
                        unsigned candidates) {
    const f4 reach = f4_load(g->reach);
    const f4 extent = f4_max(larger3(f4_abs(e->x[0]), f4_abs(e->x[1]), f4_abs(e->x[2])),
                             larger3(f4_abs(e->y[0]), f4_abs(e->y[1]), f4_abs(e->y[2])));
    const f4 error = f4_mul(reach, f4_add(f4_mul(f4_all(32.0f * PLT_U), extent),
                                          f4_mul(f4_all(128.0f * PLT_U * PLT_U), reach)));
    const unsigned sure = m4_mask(m4_or(f4_lt(error, e->least), f4_lt(e->most, f4_neg(error))));
    unsigned hits = candidates & sure;
    for (unsigned lane = 0; (candidates & ~sure) >> lane != 0; lane++) {
        if ((candidates & ~sure) >> lane & 1u) {
            hits |= (unsigned)decide_lane(t, g, e, z, lane, lane_of(error, lane)) << lane;
        }
    }
    return hits;
}

/* Where the rays are inside the triangle's own box, as boxes.c would say. */
PLT_APART_ON_SMALL_STACKS static m4 own_box(const prepared *t, const plt_group_slabs *s, f4 *enter,
                                            f4 *leave) {
    f4 n[3], f[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 p = f4_all(t->triangle->corner[0][a]), q = f4_all(t->triangle->corner[1][a]),
                 r = f4_all(t->triangle->corner[2][a]);
        const f4 lo = f4_min(f4_min(p, q), r), hi = f4_max(f4_max(p, q), r);
        const f4 rdir = f4_load(s->rdir[a]);
        const m4 negative = f4_lt(rdir, f4_zero());
        n[a] = f4_mul(f4_sub(f4_select(negative, hi, lo), f4_load(s->near_org[a])), rdir);
        f[a] = f4_mul(f4_sub(f4_select(negative, lo, hi), f4_load(s->far_org[a])), rdir);
    }
    *enter = f4_max(f4_max(n[0], n[1]), n[2]);
    *leave = f4_min(f4_min(f[0], f[1]), f[2]);
    return f4_le(*enter, *leave);
}

/* n . dir over dir[z]: no factor is above 1, so no direction that is allowed overflows. */
static inline f4 normal_along(const float normal[3], const plt_group_rays *g, int z) {
    const int ax = plt_axis_after[z], ay = plt_axis_after[ax];
    return f4_add(f4_all(normal[z]), f4_add(f4_mul(f4_all(normal[ax]), f4_load(g->slope[0])),
                                            f4_mul(f4_all(normal[ay]), f4_load(g->slope[1]))));
}

/* t = n . (p0 - org) / n . dir. */
static inline f4 plane_distance(const prepared *t, const float normal[3], const plt_group_rays *g,
                                int z, f4 along) {
    f4 numerator = f4_zero();
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 p0 = f4_sub(f4_all(t->triangle->corner[0][a]), f4_load(g->org[a]));
        numerator = f4_add(numerator, f4_mul(f4_all(normal[a]), p0));
    }
    return f4_div(f4_div(numerator, along), f4_load(g->dir[z]));
}

/* `distance`, in `lanes` computed in integers. */
RARELY f4 exact_distance(const prepared *t, const plt_group_rays *g, unsigned lanes, f4 distance,
                         f4 enter, f4 leave) {
    float at[4];
    f4_store(at, distance);
    for (unsigned lane = 0; lanes >> lane != 0; lane++) {
        if (lanes >> lane & 1u) {
            const plt_lone_ray ray = ray_of(g, 0, lane);
            at[lane] = plt_exact_distance(t->triangle->corner, ray.org, ray.dir);
        }
    }
    return f4_min(f4_max(f4_load(at), enter), leave);
}

/* Lanes whose distance needs integers, if they are hit. Neither tmin nor tmax has a say: they
 * only spare lanes that are no hit anyway. A normal whose products may underflow is scaled, and
 * the distance computed anew. */
RARELY unsigned open_lanes(const prepared *t, const plt_group_slabs *s, const plt_group_rays *g,
                           int z, f4 enter, f4 leave, float normal[3], f4 *distance) {
    float scaled[3];
    const unsigned kind = plt_scale_normal(t->triangle->corner, normal, scaled);
    const f4 along = normal_along(scaled, g, z);
    if ((kind & PLT_NORMAL_IS_SMALL) != 0) {
        memcpy(normal, scaled, sizeof scaled);
        *distance = plane_distance(t, normal, g, z, along);
    }
    unsigned open = 0;
    for (unsigned lane = 0; lane < 4; lane++) {
        const float from = lane_of(enter, lane), to = lane_of(leave, lane);
        const int is_open = plt_distance_is_open(lane_of(along, lane), kind, from, to);
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

/* u and v count from the corner that came first in the packed mesh. */
static void store_weights(plt_group_rays *g, m4 hit, const edges *e, uint32_t rotation) {
    const f4 sum = f4_add(f4_add(e->weight[0], e->weight[1]), e->weight[2]);
    const unsigned first = plt_axis_after[rotation], second = plt_axis_after[first];
    const f4 u = f4_min(f4_max(f4_div(e->weight[first], sum), f4_zero()), f4_all(1.0f));
    const f4 v = f4_min(f4_max(f4_div(e->weight[second], sum), f4_zero()), f4_all(1.0f));
    f4_store(g->u, f4_select(hit, u, f4_load(g->u)));
    f4_store(g->v, f4_select(hit, v, f4_load(g->v)));
}

/* The rays of `lanes` are those that can meet the triangle; which is a hit? */
static unsigned record_hits(const prepared *t, plt_packet *p, unsigned index, edges *e, int z,
                            unsigned lanes) {
    plt_group_slabs *s = &p->slabs.group[index];
    plt_group_rays *g = &p->rays[index];
    f4 enter, leave;
    float normal[3];
    plt_triangle_normal(t->triangle->corner, normal);
    const m4 in_box = own_box(t, s, &enter, &leave);
    const f4 along = normal_along(normal, g, z);
    f4 distance = plane_distance(t, normal, g, z, along);
    unsigned candidates = lanes & m4_mask(in_box), open = 0;
    if (f4_min_lane(f4_abs(along)) < plt_open_limit(t->triangle->longest)) {
        open = candidates & open_lanes(t, s, g, z, enter, leave, normal, &distance);
    }
    /* A NaN (0 / 0) becomes `enter` by the rule of max. */
    distance = f4_min(f4_max(distance, enter), leave);
    const uint32_t word = plt_primitive_word_find(t->triangle->ids, t->triangle->word);
    const u4 id = u4_all(plt_primitive_id(word));
    candidates &= m4_mask(nearer(s, g, distance, id)) | open;
    if (candidates == 0) {
        return 0;
    }
    unsigned hits = covered(t, g, e, z, candidates);
    if ((hits & open) != 0) {
        distance = exact_distance(t, g, hits & open, distance, enter, leave);
        hits &= m4_mask(nearer(s, g, distance, id));
    }
    const m4 hit = m4_bits(hits);
    f4_store(s->tmax, f4_select(hit, p->any ? f4_all(-1.0f) : distance, f4_load(s->tmax)));
    u4_store(g->id, u4_select(hit, id, u4_load(g->id)));
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        f4_store(g->normal[a], f4_select(hit, f4_all(normal[a]), f4_load(g->normal[a])));
    }
    store_weights(g, hit, e, plt_primitive_rotation(word));
    return hits;
}

static inline unsigned test_axis(const prepared *t, plt_packet *p, unsigned index, int z,
                                 enum sharing sharing) {
    const plt_group_rays *g = &p->rays[index];
    edges e = edges_of(t, g, z, sharing);
    const unsigned may = may_cover(t, g, &e, sharing) & g->axis_lanes[z];
    if (may == 0) {
        return 0;
    }
    edges kept = e; /* so that e stays in registers for a miss, the common case */
    return record_hits(t, p, index, PLT_LANES_REGISTERS ? &kept : &e, z, may);
}

/* Any hit: a group whose rays have all hit something leaves the packet. */
static inline void retire_group(plt_packet *p, unsigned index) {
    const plt_group_slabs *s = &p->slabs.group[index];
    const unsigned seeking = m4_mask(f4_le(f4_load(s->tmin), f4_load(s->tmax)));
    p->active &= ~plt_mask_of(index, seeking == 0);
}

static inline void test_group(const prepared *t, plt_packet *p, unsigned index,
                              enum sharing sharing) {
    unsigned hits = 0;
    if (sharing == PER_PACKET || p->axis != PLT_AXES_DIFFER) {
        hits = test_axis(t, p, index, p->axis, sharing);
    } else {
        for (int z = 0; z < 3; z++) {
            hits |= p->rays[index].axis_lanes[z] != 0 ? test_axis(t, p, index, z, sharing) : 0;
        }
    }
    if (p->any && hits != 0) {
        retire_group(p, index);
    }
}

static inline void test_groups(prepared *t, plt_packet *p, plt_mask groups, enum sharing sharing) {
    prepare(t, p, sharing);
    for (plt_mask m = groups; m != 0; m &= m - 1) {
        test_group(t, p, plt_mask_first(m), sharing);
    }
}

void plt_triangle_groups(plt_packet *p, const plt_triangle *triangle, plt_mask groups) {
    prepared t;
    t.triangle = triangle;
    if (p->slabs.coherence == PLT_ONE_ORIGIN && p->axis != PLT_AXES_DIFFER) {
        test_groups(&t, p, groups, PER_PACKET);
    } else {
        test_groups(&t, p, groups, PER_GROUP);
    }
}
