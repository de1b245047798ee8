/* packet - see packet.h
 *
 * How far origins are moved: ray_bounds.h.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/packet.h"

#include <string.h>

#include "engine/trace/ray_bounds.h"

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
    if (PLT_LANES_REGISTERS) { /* hardly any is tiny */
        const f4 least = f4_min(f4_min(f4_abs(dir[0]), f4_abs(dir[1])), f4_abs(dir[2]));
        if (m4_mask(f4_lt(least, tiny)) == 0) {
            PLT_UNROLLED for (int a = 0; a < 3; a++) {
                f4_store(s->rdir[a], f4_div(f4_all(1.0f), dir[a]));
            }
            return;
        }
    }
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
#if !PLT_WITH_HULLS
    f4_store(g->least_slack, f4_mul(f4_mul(reach, reach), f4_all(PLT_CLOSE_ERROR)));
#endif
    const f4 box_error = f4_mul(reach, f4_all(PLT_BOX_ERROR));
    for (int a = 0; a < 3; a++) {
        const f4 e = f4_max(box_error, f4_mul(f4_abs(org[a]), f4_all(PLT_ORIGIN_ERROR)));
        const m4 negative = f4_lt(dir[a], f4_zero());
        const f4 up = f4_add(org[a], e), down = f4_sub(org[a], e);
        f4_store(s->near_org[a], f4_select(negative, down, up));
        f4_store(s->far_org[a], f4_select(negative, up, down));
    }
}

/* Slopes of rays that all have their largest component along one axis. */
static inline void set_slopes(plt_group_rays *g, const f4 dir[3], int z) {
    const int x = z == 2 ? 0 : z + 1, y = z == 0 ? 2 : z - 1;
    f4_store(g->slope[0], f4_div(dir[x], dir[z]));
    f4_store(g->slope[1], f4_div(dir[y], dir[z]));
}

/* The axis of the largest component (the first of equals) and the shear that makes the ray run
 * along it: Woop et al. 2013, section 3.1. Rays that share it, as most do, choose nothing. */
static inline void set_shear(plt_group_rays *g, const f4 dir[3], unsigned valid) {
    const f4 x = f4_abs(dir[0]), y = f4_abs(dir[1]), z = f4_abs(dir[2]);
    const m4 is_x = m4_and(f4_le(y, x), f4_le(z, x));
    const m4 is_y = m4_andnot(f4_le(z, y), is_x);
    const unsigned xs = m4_mask(is_x), ys = m4_mask(is_y);
    g->axis_lanes[0] = (uint8_t)(xs & valid);
    g->axis_lanes[1] = (uint8_t)(ys & valid);
    g->axis_lanes[2] = (uint8_t)(valid & ~(xs | ys));
    if (PLT_LANES_REGISTERS && xs == 15) {
        set_slopes(g, dir, 0);
    } else if (PLT_LANES_REGISTERS && ys == 15) {
        set_slopes(g, dir, 1);
    } else if (PLT_LANES_REGISTERS && (xs | ys) == 0) {
        set_slopes(g, dir, 2);
    } else {
        const f4 along = f4_select(is_x, dir[0], f4_select(is_y, dir[1], dir[2]));
        const f4 first = f4_select(is_x, dir[1], f4_select(is_y, dir[2], dir[0]));
        const f4 second = f4_select(is_x, dir[2], f4_select(is_y, dir[0], dir[1]));
        f4_store(g->slope[0], f4_div(first, along));
        f4_store(g->slope[1], f4_div(second, along));
    }
}

void plt_packet_init(plt_packet *packet, void *memory, unsigned side) {
    const unsigned groups = side * side / 4;
    packet->slabs.group = memory;
    packet->rays = (plt_group_rays *)(void *)(packet->slabs.group + groups);
#if PLT_WITH_HULLS
    packet->hull = (plt_hull *)(void *)(packet->rays + groups);
    packet->first_group = (groups - 1) / 3;
    packet->capacity = groups;
#endif
}

static inline void set_slabs(plt_packet *p, unsigned index, const f4 org[3], const f4 dir[3]) {
    set_reciprocals(&p->slabs.group[index], dir);
    set_origins(&p->slabs.group[index], &p->rays[index], p->scene, org, dir);
}

#if PLT_WITH_HULLS
static inline float larger(float a, float b) {
    return a > b ? a : b;
}

void plt_packet_set_reach(plt_packet *p, float reach, float furthest) {
    const float moved = larger(reach * PLT_BOX_ERROR, furthest * PLT_ORIGIN_ERROR);
    p->reach = reach;
    p->least_slack = reach * reach * PLT_CLOSE_ERROR;
    p->least_sure = reach * moved * PLT_SURE_ERROR;
}

void plt_group_set_slabs(plt_packet *p, unsigned index) {
    const plt_group_rays *g = &p->rays[index];
    f4 org[3], dir[3];
    for (int a = 0; a < 3; a++) {
        org[a] = f4_load(g->org[a]);
        dir[a] = f4_load(g->dir[a]);
    }
    if (p->moved) {
        set_reciprocals(&p->slabs.group[index], dir);
        f4_store(p->rays[index].reach, f4_all(p->reach));
    } else {
        set_slabs(p, index, org, dir);
    }
    p->ready |= plt_mask_of(index, 1);
}

void plt_packet_make_ready(plt_packet *p) {
    f4 reach = f4_zero(), furthest = f4_zero();
    for (plt_mask m = p->active; m != 0; m &= m - 1) {
        const plt_group_rays *g = &p->rays[plt_mask_first(m)];
        const f4 org[3] = {f4_load(g->org[0]), f4_load(g->org[1]), f4_load(g->org[2])};
        plt_group_make_ready(p, plt_mask_first(m));
        reach = f4_max(reach, f4_load(g->reach));
        furthest = f4_max(furthest, largest_of(org));
    }
    plt_packet_set_reach(p, -f4_min_lane(f4_neg(reach)), -f4_min_lane(f4_neg(furthest)));
}
#endif

/* Lanes without a ray get another lane's, which keeps NaN out, and hulls need not reach around
 * anything else. Their interval is empty. */
#if PLT_WITH_HULLS
static void fill_lanes(f4 to[3], m4 ok) {
    const unsigned lane = (unsigned)__builtin_ctz(m4_mask(ok));
    for (int a = 0; a < 3; a++) {
        float all[4];
        f4_store(all, to[a]);
        to[a] = f4_select(ok, to[a], f4_all(all[lane]));
    }
}
#endif

void plt_packet_set_group(plt_packet *p, unsigned index, const f4 org[3], const f4 dir[3], f4 tmin,
                          f4 tmax, unsigned count) {
    plt_group_slabs *s = &p->slabs.group[index];
    plt_group_rays *g = &p->rays[index];
    const m4 ok = m4_and(valid_lanes(org, dir, tmin, tmax), m4_bits((1u << count) - 1u));
    f4 o[3], d[3];
    g->valid = (uint8_t)m4_mask(ok);
    u4_store(g->id, u4_all(PLT_MISS));
    if (g->valid == 0) {
        return;
    }
#if PLT_WITH_HULLS
    memcpy(o, org, sizeof o);
    memcpy(d, dir, sizeof d);
    if (g->valid != 15) {
        fill_lanes(o, ok);
        fill_lanes(d, ok);
    }
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        f4_store(g->org[a], o[a]);
        f4_store(g->dir[a], d[a]);
    }
#else /* they copy nothing: zeros and a fixed direction keep NaN out */
    for (int a = 0; a < 3; a++) {
        o[a] = f4_select(ok, org[a], f4_zero());
        d[a] = f4_select(ok, dir[a], f4_all(1.0f));
        f4_store(g->org[a], o[a]);
        f4_store(g->dir[a], d[a]);
    }
    set_slabs(p, index, o, d);
#endif
    set_shear(g, d, g->valid);
    f4_store(s->tmin, f4_select(ok, f4_max(tmin, f4_zero()), f4_all(1.0f)));
    f4_store(s->tmax, f4_select(ok, tmax, f4_all(-1.0f)));
    p->active |= plt_mask_of(index, 1);
}

void plt_packet_begin(plt_packet *packet, const plt_box *scene, unsigned groups, int any) {
    packet->scene = scene;
    packet->groups = groups;
    packet->active = 0;
#if PLT_WITH_HULLS
    packet->ready = packet->changed = 0;
    packet->unbounded = packet->surfaces = packet->moved = 0;
#endif
    packet->any = (uint8_t)(any != 0);
}

/* Origin and signs of one ray, which all others are compared with. */
static void copy_ray(plt_packet *p, unsigned group, unsigned lane) {
    const plt_group_slabs *s = &p->slabs.group[group];
    const plt_group_rays *g = &p->rays[group];
    plt_group_make_ready(p, group);
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        p->org[a] = g->org[a][lane];
        p->slabs.near_org[a] = s->near_org[a][lane];
        p->slabs.far_org[a] = s->far_org[a][lane];
        p->slabs.negative[a] = g->dir[a][lane] < 0.0f;
        p->slabs.backwards[a] = 0u - p->slabs.negative[a];
    }
    p->org[3] = p->slabs.near_org[3] = p->slabs.far_org[3] = 0.0f;
    p->slabs.backwards[3] = 0;
#if PLT_WITH_HULLS
    const float *o = p->org;
    plt_packet_set_reach(
        p, g->reach[lane],
        larger(larger(__builtin_fabsf(o[0]), __builtin_fabsf(o[1])), __builtin_fabsf(o[2])));
#else
    p->reach = g->reach[lane];
    p->least_slack = g->least_slack[lane];
#endif
}

static inline void compare_group(const plt_packet *p, const plt_group_rays *g, plt_common *c) {
    m4 same = m4_bits(15);
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 dir = f4_load(g->dir[a]);
        const unsigned negative = p->slabs.negative[a] ? 15u : 0u;
        same = m4_and(same, f4_eq(f4_load(g->org[a]), f4_all(p->org[a])));
        c->other_sign[a] |= (m4_mask(f4_lt(dir, f4_zero())) ^ negative) & g->valid;
        c->forward[a] = f4_add(c->forward[a], dir);
        c->axes |= (unsigned)(g->axis_lanes[a] != 0) << a;
    }
    c->is_apart |= g->valid & ~m4_mask(same);
}

static plt_common compare_groups(const plt_packet *p) {
    plt_common c = {0, 0, {0, 0, 0}, {f4_zero(), f4_zero(), f4_zero()}};
    for (plt_mask m = p->active; m != 0; m &= m - 1) {
        compare_group(p, &p->rays[plt_mask_first(m)], &c);
    }
    return c;
}

static inline void share(plt_packet *p, const plt_common *c) {
    for (int a = 0; a < 3; a++) {
        float sum[4];
        f4_store(sum, c->forward[a]);
        p->forward[a] = sum[0];
    }
    p->forward[3] = 0.0f;
    if ((c->axes & (c->axes - 1)) == 0) {
        p->axis = (uint8_t)(c->axes >> 1); /* 1, 2, 4 to 0, 1, 2 */
    }
    /* One origin needs one sign, too: moved origins follow the sign. */
    if ((c->other_sign[0] | c->other_sign[1] | c->other_sign[2]) != 0) {
        p->slabs.coherence = PLT_MIXED;
    } else if (c->is_apart != 0) {
        p->slabs.coherence = PLT_ONE_SIGN;
    }
#if PLT_WITH_HULLS
    p->along = p->axis != PLT_AXES_DIFFER && c->other_sign[p->axis] == 0;
#endif
}

static void share_nothing(plt_packet *p) {
    p->slabs.coherence = PLT_ONE_ORIGIN;
    p->axis = PLT_AXES_DIFFER;
#if PLT_WITH_HULLS
    p->along = 0;
#endif
}

void plt_packet_finish(plt_packet *p) {
    share_nothing(p);
    if (p->active == 0) {
        return;
    }
    const unsigned first = plt_mask_first(p->active);
    unsigned lane = 0;
    while (!(p->rays[first].valid >> lane & 1u)) {
        lane++;
    }
    copy_ray(p, first, lane);
    const plt_common c = compare_groups(p);
    share(p, &c);
}

#if PLT_WITH_HULLS
void plt_packet_share(plt_packet *p, const plt_common *c) {
    share_nothing(p);
    copy_ray(p, 0, 0);
    share(p, c);
}
#endif
