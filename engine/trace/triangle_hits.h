/* triangle_hits - a triangle that some groups may meet: which of their rays do, and their hits
 *
 * For triangle_lanes.c: what triangle_record.h does for the scalar engine, with the same bits.
 * Error bounds: triangle_common.h.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRIANGLE_HITS_H
#define PLT_TRACE_TRIANGLE_HITS_H

#include "engine/trace/planes.h"
#include "engine/trace/triangle.h"
#include "engine/trace/triangle_record.h"
#include "engine/trace/triangle_sieve.h"

#if PLT_WITH_HULLS

/* A triangle made ready for all groups of a packet. */
typedef struct prepared {
    f4 corner[3];    /* x, y, z */
    f4 across[3][3]; /* [corner]: along both axes across the shear's, and along that; in all
                        lanes. PER_PACKET: minus the origin */
    f4 slack;        /* 72 u R L + 320 u^2 R^2, R being the largest reach of the packet */
    f4 sure;         /* 72 u R L + 128 u R E, E being how far origins are moved at most */
    float longest;
    uint32_t word;
    const plt_primitive_ids *ids;
    int has_surface;           /* what only candidates for a hit need, set for the first of them: */
    float corner_floats[3][3]; /* as integers want them, or groups of many origins */
    float normal[4];
    f4 along[3];         /* its components along the axes of `across`, in all lanes */
    f4 numerator;        /* PER_PACKET: normal . (corner 0 - origin) */
    f4 open;             /* plt_open_limit */
    plt_planes planes;   /* of its own box */
    u4 id;               /* in all lanes */
    unsigned u_at, v_at; /* whose weights are u and v: they count from the corner that came
                            first in the packed mesh */
} prepared;

PLT_INLINED void prepare(prepared *t, const plt_packet *p, int z, enum sharing sharing) {
    const f4 org = f4_load(p->org);
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        spread(t->across[c], sharing == PER_PACKET ? f4_sub(t->corner[c], org) : t->corner[c], z);
    }
}

static inline f4 from_origin(const prepared *t, const plt_group_rays *g, int corner, int k, int z,
                             enum sharing sharing) {
    const f4 at = t->across[corner][k];
    const int axis = k == 2 ? z : k == 0 ? plt_axis_after[z] : plt_axis_after[plt_axis_after[z]];
    return sharing == PER_GROUP ? f4_sub(at, f4_load(g->org[axis])) : at;
}

/* The edge functions as seen along axis z. */
PLT_INLINED edges edges_of(const prepared *t, const plt_group_rays *g, int z,
                           enum sharing sharing) {
    const f4 slope_x = f4_load(g->slope[0]), slope_y = f4_load(g->slope[1]);
    edges e;
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        const f4 depth = from_origin(t, g, c, 2, z, sharing);
        e.x[c] = f4_sub(from_origin(t, g, c, 0, z, sharing), f4_mul(slope_x, depth));
        e.y[c] = f4_sub(from_origin(t, g, c, 1, z, sharing), f4_mul(slope_y, depth));
    }
    set_weights(&e);
    return e;
}

/* Lanes that the triangle covers, or may cover. */
static inline unsigned may_cover(const prepared *t, const edges *e) {
    return m4_mask(m4_or(f4_le(f4_neg(t->slack), e->least), f4_le(e->most, t->slack)));
}

/* Lanes that it covers without doubt, if they meet its box (DESIGN.md, section 7.8). */
static inline unsigned does_cover(const prepared *t, const edges *e) {
    return m4_mask(m4_or(f4_lt(t->sure, e->least), f4_lt(e->most, f4_neg(t->sure))));
}

/* Where the rays are inside the triangle's own box, as boxes.c would say. */
PLT_INLINED m4 own_box(const prepared *t, const plt_group_slabs *s, enum plt_coherence kind,
                       f4 *enter, f4 *leave) {
    f4 n[3], f[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 rdir = f4_load(s->rdir[a]);
        plt_plane_depths(&t->planes, a, s, rdir, rdir, kind, &n[a], &f[a]);
    }
    *enter = f4_max(f4_max(n[0], n[1]), n[2]);
    *leave = f4_min(f4_min(f[0], f[1]), f[2]);
    return f4_le(*enter, *leave);
}

/* PER_PACKET, normal . (corner 0 - origin). */
static inline f4 packet_numerator(const prepared *t, const plt_packet *p, f4 normal) {
    const f4 terms = f4_mul(normal, f4_sub(t->corner[0], f4_load(p->org)));
    return f4_add(f4_add(f4_add(f4_zero(), f4_lane(terms, 0)), f4_lane(terms, 1)),
                  f4_lane(terms, 2));
}

static void set_corner_floats(prepared *t) {
    for (int c = 0; c < 3; c++) {
        float at[4];
        f4_store(at, t->corner[c]);
        memcpy(t->corner_floats[c], at, sizeof t->corner_floats[c]);
    }
}

/* Planes of its own box, and of one origin the plane that it lies in. */
static inline void set_planes(prepared *t, const plt_packet *p, f4 normal) {
    const f4 lo = f4_min(f4_min(t->corner[0], t->corner[1]), t->corner[2]);
    const f4 hi = larger3(t->corner[0], t->corner[1], t->corner[2]);
    switch (p->slabs.coherence) {
    case PLT_ONE_ORIGIN:
        plt_planes_set(&t->planes, &p->slabs, lo, hi, PLT_ONE_ORIGIN);
        t->numerator = packet_numerator(t, p, normal);
        break;
    case PLT_ONE_SIGN:
        set_corner_floats(t);
        plt_planes_set(&t->planes, &p->slabs, lo, hi, PLT_ONE_SIGN);
        break;
    default:
        set_corner_floats(t);
        plt_planes_set(&t->planes, &p->slabs, lo, hi, PLT_MIXED);
        break;
    }
}

/* What only candidates need of a triangle. */
RARELY void set_surface(prepared *t, const plt_packet *p, int z) {
    const f4 first = f4_sub(t->corner[1], t->corner[0]),
             second = f4_sub(t->corner[2], t->corner[0]);
    const f4 first_y = f4_turn(first), second_y = f4_turn(second);
    const f4 normal =
        f4_sub(f4_mul(first_y, f4_turn(second_y)), f4_mul(f4_turn(first_y), second_y));
    const uint32_t word = plt_primitive_word_find(t->ids, t->word);
    t->has_surface = 1;
    f4_store(t->normal, normal);
    spread(t->along, normal, z);
    t->open = f4_all(plt_open_limit(t->longest));
    t->id = u4_all(plt_primitive_id(word));
    if (!p->surfaces) {
        t->u_at = plt_axis_after[plt_primitive_rotation(word)];
        t->v_at = plt_axis_after[t->u_at];
    }
    set_planes(t, p, normal);
}

/* Four rays that pass a triangle. */
typedef struct passed {
    f4 weight[3]; /* edge functions */
    f4 distance, enter, leave;
    float normal[3];
    unsigned sure, open; /* lanes it covers without doubt, and that need integers */
    int z;
} passed;

/* As triangle_record.h wants it. */
static passing passing_of(prepared *t, const passed *at) {
    passing to;
    set_corner_floats(t);
    to.corner = t->corner_floats;
    to.longest = t->longest;
    to.enter = at->enter;
    to.leave = at->leave;
    memcpy(to.normal, at->normal, sizeof to.normal);
    return to;
}

/* Of lanes some of which it may not cover those that it covers. */
RARELY unsigned decide(prepared *t, const plt_group_rays *g, passed *at, unsigned lanes) {
    const int ax = plt_axis_after[at->z], ay = plt_axis_after[ax];
    const passing with = passing_of(t, at);
    edges e;
    for (int c = 0; c < 3; c++) {
        const float *corner = t->corner_floats[c];
        const f4 depth = f4_sub(f4_all(corner[at->z]), f4_load(g->org[at->z]));
        e.x[c] = f4_sub(f4_sub(f4_all(corner[ax]), f4_load(g->org[ax])),
                        f4_mul(f4_load(g->slope[0]), depth));
        e.y[c] = f4_sub(f4_sub(f4_all(corner[ay]), f4_load(g->org[ay])),
                        f4_mul(f4_load(g->slope[1]), depth));
    }
    set_weights(&e);
    const unsigned hits = covered(&with, g, &e, at->z, lanes);
    memcpy(at->weight, e.weight, sizeof at->weight); /* some may have been too coarse */
    return hits;
}

/* Lanes of `lanes` that need integers for t. */
RARELY unsigned find_open(prepared *t, const plt_group_slabs *s, const plt_group_rays *g,
                          passed *at, unsigned lanes) {
    passing with = passing_of(t, at);
    const unsigned open = lanes & open_lanes(&with, s, g, at->z, &at->distance);
    memcpy(at->normal, with.normal, sizeof at->normal);
    return open;
}

RARELY f4 distance_of_open(prepared *t, const plt_group_rays *g, const passed *at, unsigned lanes) {
    const passing with = passing_of(t, at);
    return exact_distance(&with, g, lanes, at->distance);
}

/* Sets t where the rays pass the plane, held within the triangle's box. Returns those of `lanes`
 * that pass the box. */
PLT_INLINED unsigned pass(prepared *t, const plt_group_slabs *s, const plt_group_rays *g,
                          passed *at, unsigned lanes, enum plt_coherence kind) {
    const f4 along = f4_add(t->along[2], f4_add(f4_mul(t->along[0], f4_load(g->slope[0])),
                                                f4_mul(t->along[1], f4_load(g->slope[1]))));
    const f4 numerator =
        kind == PLT_ONE_ORIGIN ? t->numerator : plane_numerator(t->corner_floats[0], t->normal, g);
    at->distance = plane_distance(numerator, g, at->z, along);
    lanes &= m4_mask(own_box(t, s, kind, &at->enter, &at->leave));
    at->open = 0;
    if ((m4_mask(f4_lt(f4_abs(along), t->open)) & lanes) != 0) {
        at->open = find_open(t, s, g, at, lanes);
    }
    /* A NaN (0 / 0) becomes `enter` by the rule of max. */
    at->distance = f4_min(f4_max(at->distance, at->enter), at->leave);
    return lanes;
}

static inline f4 weight_share(const passed *at, unsigned of, f4 sum) {
    return f4_min(f4_max(f4_div(at->weight[of], sum), f4_zero()), f4_all(1.0f));
}

static inline void keep(float to[4], m4 hit, f4 value) {
    f4_store(to, f4_select(hit, value, f4_load(to)));
}

/* The nearest hits so far. */
static inline void store_nearest(const prepared *t, plt_group_slabs *s, plt_group_rays *g,
                                 const passed *at, m4 hit, int surfaces) {
    keep(s->tmax, hit, at->distance);
    u4_store(g->id, u4_select(hit, t->id, u4_load(g->id)));
    if (surfaces) {
        for (int a = 0; a < 3; a++) {
            keep(g->normal[a], hit, f4_all(at->normal[a]));
        }
        return;
    }
    const f4 sum = f4_add(f4_add(at->weight[0], at->weight[1]), at->weight[2]);
    keep(g->u, hit, weight_share(at, t->u_at, sum));
    keep(g->v, hit, weight_share(at, t->v_at, sum));
}

/* Any hit: a ray that has one seeks no other. */
static inline void store_any(plt_packet *p, unsigned index, m4 hit, u4 id) {
    keep(p->slabs.group[index].tmax, hit, f4_all(-1.0f));
    u4_store(p->rays[index].id, u4_select(hit, id, u4_load(p->rays[index].id)));
    retire_group(p, index);
}

/* The rays of `lanes` are those that can meet the triangle; which is a hit? */
PLT_INLINED void record_kind(prepared *t, plt_packet *p, unsigned index, passed *at, unsigned lanes,
                             enum plt_coherence kind) {
    plt_group_slabs *s = &p->slabs.group[index];
    plt_group_rays *g = &p->rays[index];
    memcpy(at->normal, t->normal, sizeof at->normal);
    lanes = pass(t, s, g, at, lanes, kind);
    lanes &= m4_mask(nearer(s, g, at->distance, t->id)) | at->open;
    if (lanes == 0) {
        return;
    }
    unsigned hits = (lanes & ~at->sure) == 0 ? lanes : decide(t, g, at, lanes);
    if ((hits & at->open) != 0) {
        at->distance = distance_of_open(t, g, at, hits & at->open);
        hits &= m4_mask(nearer(s, g, at->distance, t->id));
    }
    p->changed |= plt_mask_of(index, hits != 0);
    if (p->any) {
        store_any(p, index, m4_bits(hits), t->id);
    } else {
        store_nearest(t, s, g, at, m4_bits(hits), p->surfaces);
    }
}

/* PER_PACKET says that there is one origin. */
PLT_INLINED void record_hits(prepared *t, plt_packet *p, unsigned index, passed *at, unsigned lanes,
                             enum sharing sharing) {
    plt_group_make_ready(p, index);
    if (!t->has_surface) {
        set_surface(t, p, at->z);
    }
    if (sharing == PER_PACKET || p->slabs.coherence == PLT_ONE_ORIGIN) {
        record_kind(t, p, index, at, lanes, PLT_ONE_ORIGIN);
    } else if (p->slabs.coherence == PLT_ONE_SIGN) {
        record_kind(t, p, index, at, lanes, PLT_ONE_SIGN);
    } else {
        record_kind(t, p, index, at, lanes, PLT_MIXED);
    }
}

RARELY void record_per_packet(prepared *t, plt_packet *p, unsigned index, passed *at,
                              unsigned lanes) {
    record_hits(t, p, index, at, lanes, PER_PACKET);
}

RARELY void record_per_group(prepared *t, plt_packet *p, unsigned index, passed *at,
                             unsigned lanes) {
    record_hits(t, p, index, at, lanes, PER_GROUP);
}

/* A candidate of a packet whose hits have normals; `lanes` as they passed the sieve. */
PLT_INLINED void test_surface(prepared *t, plt_packet *p, unsigned index, int z, unsigned lanes) {
    passed at;
    at.z = z;
    at.sure = lanes >> 4 & 15u;
    lanes &= p->rays[index].axis_lanes[z];
    if (lanes != 0) {
        record_per_packet(t, p, index, &at, lanes);
    }
}

PLT_INLINED void test_candidate(prepared *t, plt_packet *p, unsigned index, int z,
                                enum sharing sharing) {
    const plt_group_rays *g = &p->rays[index];
    const edges e = edges_of(t, g, z, sharing);
    const unsigned may = may_cover(t, &e) & g->axis_lanes[z];
    if (may == 0) {
        return;
    }
    passed at;
    at.z = z;
    at.sure = does_cover(t, &e);
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        at.weight[c] = e.weight[c];
    }
    if (sharing == PER_PACKET) {
        record_per_packet(t, p, index, &at, may);
    } else {
        record_per_group(t, p, index, &at, may);
    }
}

#endif

#endif
