/* packet - see packet.h
 *
 * How far origins are moved (e, per axis; u = 2^-24, R = the reach, the largest
 * distance on any axis from the origin to the scene's box): a plane's distance
 * is off by at most 3 u of itself, on each of two axes that are compared. So
 * e = 16 u R, or 4 u |org| where that is more so that the sum does not round
 * away; at least 12 u R of it are left, and a box that a ray meets is never
 * missed. The idea is Woop, Benthin and Wald, "Watertight
 * ray/triangle intersection", 2013, section 5.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/packet.h"

#define LARGEST 1.152921504606846976e18f    /* 2^60 */
#define SMALLEST 8.67361737988403547e-19f   /* 2^-60 */
#define BOX_ERROR 9.5367431640625e-7f       /* 16 u = 2^-20 */
#define ORIGIN_ERROR 2.384185791015625e-7f  /* 4 u = 2^-22 */
#define CLOSE_ERROR 1.1368683772161603e-12f /* 320 u^2 */
#define REACH_ROUNDING 1.000001f            /* the differences were rounded */

static f4 largest_of(const f4 a[3]) {
    return f4_max(f4_max(f4_abs(a[0]), f4_abs(a[1])), f4_abs(a[2]));
}

/* Lanes with all of `a` within +-limit; false for NaN. */
static m4 within(const f4 a[3], float limit) {
    const f4 most = f4_all(limit);
    return m4_and(m4_and(f4_le(f4_abs(a[0]), most), f4_le(f4_abs(a[1]), most)),
                  f4_le(f4_abs(a[2]), most));
}

static m4 valid_lanes(const f4 org[3], const f4 dir[3], f4 tmin, f4 tmax) {
    const m4 length = f4_le(f4_all(SMALLEST), largest_of(dir));
    const m4 range = m4_and(f4_le(tmin, tmax), f4_le(f4_zero(), tmax));
    return m4_and(m4_and(within(org, PLT_COORD_MAX), within(dir, LARGEST)), m4_and(length, range));
}

static void set_reciprocals(plt_group *g, const f4 dir[3]) {
    const f4 tiny = f4_mul(largest_of(dir), f4_all(SMALLEST));
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 signed_tiny = f4_select(f4_lt(dir[a], f4_zero()), f4_neg(tiny), tiny);
        const f4 d = f4_select(f4_lt(f4_abs(dir[a]), tiny), signed_tiny, dir[a]);
        f4_store(g->rdir[a], f4_div(f4_all(1.0f), d));
    }
}

static void set_origins(plt_group *g, const plt_box *scene, const f4 org[3], const f4 dir[3]) {
    f4 reach = f4_zero();
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        reach = f4_max(f4_abs(f4_sub(f4_all(scene->lo[a]), org[a])), reach);
        reach = f4_max(f4_abs(f4_sub(f4_all(scene->hi[a]), org[a])), reach);
    }
    reach = f4_mul(reach, f4_all(REACH_ROUNDING));
    f4_store(g->reach, reach);
    f4_store(g->reach_error, f4_mul(f4_mul(reach, reach), f4_all(CLOSE_ERROR)));
    const f4 box_error = f4_mul(reach, f4_all(BOX_ERROR));
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 e = f4_max(box_error, f4_mul(f4_abs(org[a]), f4_all(ORIGIN_ERROR)));
        const m4 negative = f4_lt(dir[a], f4_zero());
        const f4 up = f4_add(org[a], e), down = f4_sub(org[a], e);
        f4_store(g->near_org[a], f4_select(negative, down, up));
        f4_store(g->far_org[a], f4_select(negative, up, down));
    }
}

/* The axis of the largest component (the first of equals) and the shear that
 * makes the ray run along it: Woop et al. 2013, section 3.1. */
static void set_shear(plt_group *g, const f4 dir[3], unsigned valid) {
    const f4 x = f4_abs(dir[0]), y = f4_abs(dir[1]), z = f4_abs(dir[2]);
    const m4 is_x = m4_and(f4_le(y, x), f4_le(z, x));
    const m4 is_y = m4_andnot(f4_le(z, y), is_x);
    const f4 along = f4_select(is_x, dir[0], f4_select(is_y, dir[1], dir[2]));
    const f4 first = f4_select(is_x, dir[1], f4_select(is_y, dir[2], dir[0]));
    const f4 second = f4_select(is_x, dir[2], f4_select(is_y, dir[0], dir[1]));
    f4_store(g->slope[0], f4_div(first, along));
    f4_store(g->slope[1], f4_div(second, along));
    g->axis_lanes[0] = (uint8_t)(m4_mask(is_x) & valid);
    g->axis_lanes[1] = (uint8_t)(m4_mask(is_y) & valid);
    g->axis_lanes[2] = (uint8_t)(valid & ~(m4_mask(is_x) | m4_mask(is_y)));
}

void plt_group_set(plt_packet *packet, unsigned index, const plt_box *scene, const f4 org[3],
                   const f4 dir[3], f4 tmin, f4 tmax, unsigned count) {
    plt_group *g = &packet->group[index];
    const m4 ok = m4_and(valid_lanes(org, dir, tmin, tmax), m4_bits((1u << count) - 1u));
    g->valid = (uint8_t)m4_mask(ok);
    if (g->valid == 0) {
        return;
    }
    /* Lanes without a ray copy nothing: zeros and a fixed direction keep NaN out. */
    f4 o[3], d[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        o[a] = f4_select(ok, org[a], f4_zero());
        d[a] = f4_select(ok, dir[a], f4_all(1.0f));
        f4_store(g->org[a], o[a]);
        f4_store(g->dir[a], d[a]);
    }
    set_reciprocals(g, d);
    set_origins(g, scene, o, d);
    set_shear(g, d, g->valid);
    f4_store(g->tmin, f4_select(ok, f4_max(tmin, f4_zero()), f4_all(1.0f)));
    f4_store(g->tmax, f4_select(ok, tmax, f4_all(-1.0f)));
    u4_store(g->source, u4_all(PLT_MISS));
    packet->active |= plt_mask_of(index, 1);
}

void plt_packet_begin(plt_packet *packet, unsigned groups, int any) {
    packet->groups = groups;
    packet->active = 0;
    packet->any = (uint8_t)(any != 0);
}

/* Lanes of `g` whose `row` equals x. */
static unsigned lanes_equal(const float row[4], float x) {
    return m4_mask(f4_eq(f4_load(row), f4_all(x)));
}

static unsigned lanes_negative(const plt_group *g, int axis) {
    return m4_mask(f4_lt(f4_load(g->rdir[axis]), f4_zero())) & g->valid;
}

static void take_from_first(plt_packet *p, const plt_group *g, unsigned lane) {
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        p->org[a] = g->org[a][lane];
        p->negative[a] = g->rdir[a][lane] < 0.0f;
        p->forward[a] = 0.0f;
    }
}

void plt_packet_finish(plt_packet *p) {
    p->mixed = 0;
    p->shared = 1;
    p->axis = 3;
    if (p->active == 0) {
        return;
    }
    const plt_group *first = &p->group[plt_mask_first(p->active)];
    unsigned lane = 0;
    while (!(first->valid >> lane & 1u)) {
        lane++;
    }
    take_from_first(p, first, lane);
    unsigned axes = 0;
    for (plt_mask m = p->active; m != 0; m &= m - 1) {
        const plt_group *g = &p->group[plt_mask_first(m)];
        PLT_UNROLLED for (int a = 0; a < 3; a++) {
            p->shared &= (g->valid & ~lanes_equal(g->org[a], p->org[a])) == 0;
            p->mixed |= lanes_negative(g, a) != (p->negative[a] ? g->valid : 0u);
            axes |= (unsigned)(g->axis_lanes[a] != 0) << a;
        }
        if (!(g->valid & 1u)) {
            continue;
        }
        PLT_UNROLLED for (int a = 0; a < 3; a++) {
            p->forward[a] += g->dir[a][0];
        }
    }
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        p->near_org[a] = first->near_org[a][lane];
        p->far_org[a] = first->far_org[a][lane];
    }
    p->reach = first->reach[lane];
    p->reach_error = first->reach_error[lane];
    if ((axes & (axes - 1)) == 0) {
        p->axis = (uint8_t)(axes >> 1); /* 1, 2, 4 to 0, 1, 2 */
    }
    p->shared &= !p->mixed; /* the short cut needs one sign: moved origins follow it */
}
