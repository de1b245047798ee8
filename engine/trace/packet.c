/* packet - see packet.h
 *
 * How far origins are moved: ray_bounds.h.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/packet.h"

#include "engine/trace/ray_bounds.h"

#define CLOSE_ERROR 1.1368683772161603e-12f /* 320 u^2 */

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
    const m4 length = f4_le(f4_all(PLT_DIR_LEAST), largest_of(dir));
    const m4 range = m4_and(f4_le(tmin, tmax), f4_le(f4_zero(), tmax));
    return m4_and(m4_and(within(org, PLT_COORD_MAX), within(dir, PLT_DIR_MOST)),
                  m4_and(length, range));
}

static void set_reciprocals(plt_group_slabs *s, const f4 dir[3]) {
    const f4 tiny = f4_mul(largest_of(dir), f4_all(PLT_DIR_LEAST));
    for (int a = 0; a < 3; a++) {
        const f4 signed_tiny = f4_select(f4_lt(dir[a], f4_zero()), f4_neg(tiny), tiny);
        const f4 d = f4_select(f4_lt(f4_abs(dir[a]), tiny), signed_tiny, dir[a]);
        f4_store(s->rdir[a], f4_div(f4_all(1.0f), d));
    }
}

static void set_origins(plt_group_slabs *s, plt_group_rays *g, const plt_box *scene,
                        const f4 org[3], const f4 dir[3]) {
    f4 reach = f4_all(PLT_REACH_LEAST);
    for (int a = 0; a < 3; a++) {
        reach = f4_max(f4_abs(f4_sub(f4_all(scene->lo[a]), org[a])), reach);
        reach = f4_max(f4_abs(f4_sub(f4_all(scene->hi[a]), org[a])), reach);
    }
    reach = f4_mul(reach, f4_all(PLT_REACH_ROUNDING));
    f4_store(g->reach, reach);
    f4_store(g->least_slack, f4_mul(f4_mul(reach, reach), f4_all(CLOSE_ERROR)));
    const f4 box_error = f4_mul(reach, f4_all(PLT_BOX_ERROR));
    for (int a = 0; a < 3; a++) {
        const f4 e = f4_max(box_error, f4_mul(f4_abs(org[a]), f4_all(PLT_ORIGIN_ERROR)));
        const m4 negative = f4_lt(dir[a], f4_zero());
        const f4 up = f4_add(org[a], e), down = f4_sub(org[a], e);
        f4_store(s->near_org[a], f4_select(negative, down, up));
        f4_store(s->far_org[a], f4_select(negative, up, down));
    }
}

/* The axis of the largest component (the first of equals) and the shear that
 * makes the ray run along it: Woop et al. 2013, section 3.1. */
static void set_shear(plt_group_rays *g, const f4 dir[3], unsigned valid) {
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

void plt_packet_init(plt_packet *packet, void *memory, unsigned side) {
    packet->slabs.group = memory;
    packet->rays = (plt_group_rays *)(void *)(packet->slabs.group + side * side / 4);
}

void plt_packet_set_group(plt_packet *packet, unsigned index, const plt_box *scene, const f4 org[3],
                          const f4 dir[3], f4 tmin, f4 tmax, unsigned count) {
    plt_group_slabs *s = &packet->slabs.group[index];
    plt_group_rays *g = &packet->rays[index];
    const m4 ok = m4_and(valid_lanes(org, dir, tmin, tmax), m4_bits((1u << count) - 1u));
    g->valid = (uint8_t)m4_mask(ok);
    if (g->valid == 0) {
        return;
    }
    /* Lanes without a ray copy nothing: zeros and a fixed direction keep NaN out. */
    f4 o[3], d[3];
    for (int a = 0; a < 3; a++) {
        o[a] = f4_select(ok, org[a], f4_zero());
        d[a] = f4_select(ok, dir[a], f4_all(1.0f));
        f4_store(g->org[a], o[a]);
        f4_store(g->dir[a], d[a]);
    }
    set_reciprocals(s, d);
    set_origins(s, g, scene, o, d);
    set_shear(g, d, g->valid);
    f4_store(s->tmin, f4_select(ok, f4_max(tmin, f4_zero()), f4_all(1.0f)));
    f4_store(s->tmax, f4_select(ok, tmax, f4_all(-1.0f)));
    u4_store(g->id, u4_all(PLT_MISS));
    packet->active |= plt_mask_of(index, 1);
}

void plt_packet_begin(plt_packet *packet, unsigned groups, int any) {
    packet->groups = groups;
    packet->active = 0;
    packet->any = (uint8_t)(any != 0);
}

/* Lanes whose `row` equals x. */
static unsigned lanes_equal(const float row[4], float x) {
    return m4_mask(f4_eq(f4_load(row), f4_all(x)));
}

static unsigned lanes_negative(const float row[4]) {
    return m4_mask(f4_lt(f4_load(row), f4_zero()));
}

/* Origin and signs of one ray, which all others are compared with. */
static void copy_ray(plt_packet *p, unsigned group, unsigned lane) {
    const plt_group_slabs *s = &p->slabs.group[group];
    const plt_group_rays *g = &p->rays[group];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        p->org[a] = g->org[a][lane];
        p->slabs.near_org[a] = s->near_org[a][lane];
        p->slabs.far_org[a] = s->far_org[a][lane];
        p->slabs.negative[a] = s->rdir[a][lane] < 0.0f;
        p->forward[a] = 0.0f;
    }
    p->reach = g->reach[lane];
    p->least_slack = g->least_slack[lane];
}

/* What a group has in common with the ray that was copied. */
typedef struct common {
    unsigned is_mixed, is_apart; /* 0: so far all are alike */
    unsigned axes;               /* a bit per axis that is the largest of some ray */
} common;

static void compare_group(plt_packet *p, unsigned group, common *c) {
    const plt_group_slabs *s = &p->slabs.group[group];
    const plt_group_rays *g = &p->rays[group];
    const unsigned valid = g->valid;
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const unsigned negative = p->slabs.negative[a] ? valid : 0u;
        c->is_apart |= valid & ~lanes_equal(g->org[a], p->org[a]);
        c->is_mixed |= (lanes_negative(s->rdir[a]) & valid) ^ negative;
        c->axes |= (unsigned)(g->axis_lanes[a] != 0) << a;
    }
    if (valid & 1u) {
        PLT_UNROLLED for (int a = 0; a < 3; a++) {
            p->forward[a] += g->dir[a][0];
        }
    }
}

void plt_packet_finish(plt_packet *p) {
    p->slabs.coherence = PLT_ONE_ORIGIN;
    p->axis = PLT_AXES_DIFFER;
    if (p->active == 0) {
        return;
    }
    const unsigned first = plt_mask_first(p->active);
    unsigned lane = 0;
    while (!(p->rays[first].valid >> lane & 1u)) {
        lane++;
    }
    copy_ray(p, first, lane);
    common c = {0, 0, 0};
    for (plt_mask m = p->active; m != 0; m &= m - 1) {
        compare_group(p, plt_mask_first(m), &c);
    }
    if ((c.axes & (c.axes - 1)) == 0) {
        p->axis = (uint8_t)(c.axes >> 1); /* 1, 2, 4 to 0, 1, 2 */
    }
    /* One origin needs one sign, too: moved origins follow the sign. */
    if (c.is_mixed) {
        p->slabs.coherence = PLT_MIXED;
    } else if (c.is_apart) {
        p->slabs.coherence = PLT_ONE_SIGN;
    }
}
