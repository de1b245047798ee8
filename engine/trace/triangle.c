/* triangle - see triangle.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/triangle.h"

static const uint8_t axis_after[3] = {1, 2, 0};

/* A triangle made ready for all groups of a packet. */
typedef struct prepared {
    float corner[3][3];
    float normal[3];
    f4 from_org[3][3]; /* shared origin: corner - origin, in all lanes */
    uint32_t number, source;
} prepared;

/* The edge functions of four rays; each is twice a signed area. */
typedef struct edges {
    f4 u, v, w, sum;
} edges;

static void normal_of(const float c[3][3], float normal[3]) {
    const float x1 = c[1][0] - c[0][0], y1 = c[1][1] - c[0][1], z1 = c[1][2] - c[0][2];
    const float x2 = c[2][0] - c[0][0], y2 = c[2][1] - c[0][1], z2 = c[2][2] - c[0][2];
    normal[0] = y1 * z2 - z1 * y2;
    normal[1] = z1 * x2 - x1 * z2;
    normal[2] = x1 * y2 - y1 * x2;
}

static void corners_of(const plt_record *record, float corner[3][3]) {
    for (int c = 0; c < 3; c++) {
        for (int a = 0; a < 3; a++) {
            corner[c][a] = plt_record_float(record, c, a);
        }
    }
}

void plt_record_normal(const plt_record *record, float normal[3]) {
    float corner[3][3];
    corners_of(record, corner);
    normal_of((const float(*)[3])corner, normal);
}

/* Returns 0 for a triangle that nothing can hit. */
static int prepare(prepared *t, const plt_packet *p, const plt_record *record, uint32_t number) {
    corners_of(record, t->corner);
    normal_of((const float(*)[3])t->corner, t->normal);
    if (t->normal[0] == 0.0f && t->normal[1] == 0.0f && t->normal[2] == 0.0f) {
        return 0;
    }
    t->number = number;
    t->source = plt_record_source(record);
    for (int c = 0; c < 3 && p->shared; c++) {
        for (int a = 0; a < 3; a++) {
            t->from_org[c][a] = f4_all(t->corner[c][a] - p->org[a]);
        }
    }
    return 1;
}

static inline f4 from_origin(const prepared *t, const plt_group *g, int corner, int axis,
                             int shared) {
    return shared ? t->from_org[corner][axis]
                  : f4_sub(f4_all(t->corner[corner][axis]), f4_load(g->org[axis]));
}

static inline f4 cross(f4 ax, f4 ay, f4 bx, f4 by) {
    return f4_sub(f4_mul(ax, by), f4_mul(ay, bx));
}

/* Lanes that the triangle covers, seen along axis z. */
static inline m4 covers(const prepared *t, const plt_group *g, int z, int shared, edges *e) {
    const int ax = axis_after[z], ay = axis_after[ax];
    const f4 slope_x = f4_load(g->slope[0]), slope_y = f4_load(g->slope[1]);
    f4 x[3], y[3];
    for (int c = 0; c < 3; c++) {
        const f4 depth = from_origin(t, g, c, z, shared);
        x[c] = f4_sub(from_origin(t, g, c, ax, shared), f4_mul(slope_x, depth));
        y[c] = f4_sub(from_origin(t, g, c, ay, shared), f4_mul(slope_y, depth));
    }
    e->u = cross(x[2], y[2], x[1], y[1]);
    e->v = cross(x[0], y[0], x[2], y[2]);
    e->w = cross(x[1], y[1], x[0], y[0]);
    const f4 least = f4_min(f4_min(e->u, e->v), e->w);
    const f4 most = f4_max(f4_max(e->u, e->v), e->w);
    e->sum = f4_add(f4_add(e->u, e->v), e->w);
    const m4 inside = m4_or(f4_le(f4_zero(), least), f4_le(most, f4_zero()));
    return m4_andnot(inside, f4_eq(e->sum, f4_zero()));
}

/* Where the rays are inside the triangle's own box, as boxes.c would say. */
static m4 own_box(const prepared *t, const plt_group *g, f4 *enter, f4 *leave) {
    f4 n[3], f[3];
    for (int a = 0; a < 3; a++) {
        const f4 p = f4_all(t->corner[0][a]), q = f4_all(t->corner[1][a]),
                 r = f4_all(t->corner[2][a]);
        const f4 lo = f4_min(f4_min(p, q), r), hi = f4_max(f4_max(p, q), r);
        const f4 rdir = f4_load(g->rdir[a]);
        const m4 negative = f4_lt(rdir, f4_zero());
        n[a] = f4_mul(f4_sub(f4_select(negative, hi, lo), f4_load(g->near_org[a])), rdir);
        f[a] = f4_mul(f4_sub(f4_select(negative, lo, hi), f4_load(g->far_org[a])), rdir);
    }
    *enter = f4_max(f4_max(n[0], n[1]), n[2]);
    *leave = f4_min(f4_min(f[0], f[1]), f[2]);
    return f4_le(*enter, *leave);
}

/* t = n . (p0 - org) / n . dir, with dir as its component along z times the
 * slopes: no factor is above 1, so no direction that is allowed overflows. A
 * NaN (0 / 0) becomes `enter` by the rule of max. */
static f4 plane_distance(const prepared *t, const plt_group *g, int z, f4 enter, f4 leave) {
    const int ax = axis_after[z], ay = axis_after[ax];
    f4 above = f4_zero();
    for (int a = 0; a < 3; a++) {
        const f4 p0 = f4_sub(f4_all(t->corner[0][a]), f4_load(g->org[a]));
        above = f4_add(above, f4_mul(f4_all(t->normal[a]), p0));
    }
    const f4 along = f4_add(f4_all(t->normal[z]),
                            f4_add(f4_mul(f4_all(t->normal[ax]), f4_load(g->slope[0])),
                                   f4_mul(f4_all(t->normal[ay]), f4_load(g->slope[1]))));
    const f4 distance = f4_div(f4_div(above, along), f4_load(g->dir[z]));
    return f4_min(f4_max(distance, enter), leave);
}

static m4 nearer(const plt_group *g, f4 t, u4 source) {
    const f4 tmax = f4_load(g->tmax);
    const m4 tie = m4_and(f4_eq(t, tmax), u4_lt(source, u4_load(g->source)));
    return m4_and(f4_le(f4_load(g->tmin), t), m4_or(f4_lt(t, tmax), tie));
}

/* The rays of `covered` meet the triangle somewhere; is it a hit? */
static unsigned record_hits(const prepared *t, plt_group *g, const edges *e, int z, m4 covered,
                            int any) {
    f4 enter, leave;
    const m4 in_box = own_box(t, g, &enter, &leave);
    const f4 distance = plane_distance(t, g, z, enter, leave);
    const u4 source = u4_all(t->source);
    const m4 hit = m4_and(m4_and(covered, in_box), nearer(g, distance, source));
    const unsigned lanes = m4_mask(hit);
    if (lanes == 0) {
        return 0;
    }
    f4_store(g->tmax, f4_select(hit, any ? f4_all(-1.0f) : distance, f4_load(g->tmax)));
    u4_store(g->source, u4_select(hit, source, u4_load(g->source)));
    u4_store(g->record, u4_select(hit, u4_all(t->number), u4_load(g->record)));
    f4_store(g->u, f4_select(hit, f4_div(e->v, e->sum), f4_load(g->u)));
    f4_store(g->v, f4_select(hit, f4_div(e->w, e->sum), f4_load(g->v)));
    return lanes;
}

static inline void test_group(plt_packet *p, const prepared *t, unsigned index, int shared) {
    plt_group *g = &p->group[index];
    unsigned hits = 0;
    for (int z = 0; z < 3; z++) {
        if (g->axis_lanes[z] == 0) {
            continue;
        }
        edges e;
        const m4 covered = m4_and(covers(t, g, z, shared, &e), m4_bits(g->axis_lanes[z]));
        if (m4_mask(covered) != 0) {
            hits |= record_hits(t, g, &e, z, covered, p->any);
        }
    }
    if (p->any && hits != 0) {
        const unsigned seeking = m4_mask(f4_le(f4_load(g->tmin), f4_load(g->tmax)));
        p->active &= ~plt_mask_of(index, seeking == 0);
    }
}

void plt_triangle_groups(plt_packet *p, const plt_record *record, uint32_t number,
                         plt_mask groups) {
    prepared t;
    if (!prepare(&t, p, record, number)) {
        return;
    }
    for (plt_mask m = groups; m != 0; m &= m - 1) {
        if (p->shared) {
            test_group(p, &t, plt_mask_first(m), 1);
        } else {
            test_group(p, &t, plt_mask_first(m), 0);
        }
    }
}
