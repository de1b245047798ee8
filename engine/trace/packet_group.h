/* packet_group - four rays made ready as a group, and what groups have in common
 *
 * By the lanes of whoever includes it: packet_set.c, and packet_quick.c where lanes flush
 * subnormals. How far origins are moved: ray_bounds.h.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_PACKET_GROUP_H
#define PLT_TRACE_PACKET_GROUP_H

#include <string.h>

#include "engine/trace/packet.h"
#include "engine/trace/ray_bounds.h"

static inline f4 largest_of(const f4 a[3]) {
    return f4_max(f4_max(f4_abs(a[0]), f4_abs(a[1])), f4_abs(a[2]));
}

/* Lanes with all of `a` within +-limit; false for NaN. */
static inline m4 within(const f4 a[3], float limit) {
    const f4 most = f4_all(limit);
    return m4_and(m4_and(f4_le(f4_abs(a[0]), most), f4_le(f4_abs(a[1]), most)),
                  f4_le(f4_abs(a[2]), most));
}

static inline m4 valid_lanes(const f4 org[3], const f4 dir[3], f4 tmin, f4 tmax) {
    const m4 length = f4_le(f4_all(PLT_DIR_LEAST), largest_of(dir));
    const m4 range = m4_and(f4_le(tmin, tmax), f4_le(f4_zero(), tmax));
    return m4_and(m4_and(within(org, PLT_COORD_MAX), within(dir, PLT_DIR_MOST)),
                  m4_and(length, range));
}

static inline void set_reciprocals(plt_group_slabs *s, const f4 dir[3]) {
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

static inline void set_origins(plt_group_slabs *s, plt_group_rays *g, const plt_box *scene,
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

static inline void set_slabs(plt_packet *p, unsigned index, const f4 org[3], const f4 dir[3]) {
    set_reciprocals(&p->slabs.group[index], dir);
    set_origins(&p->slabs.group[index], &p->rays[index], p->scene, org, dir);
}

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

/* Of lanes before `count`. 0: none has a valid ray. */
static inline int set_group(plt_packet *p, unsigned index, const f4 org[3], const f4 dir[3],
                            f4 tmin, f4 tmax, unsigned count) {
    plt_group_slabs *s = &p->slabs.group[index];
    plt_group_rays *g = &p->rays[index];
    const m4 ok = m4_and(valid_lanes(org, dir, tmin, tmax), m4_bits((1u << count) - 1u));
    f4 o[3], d[3];
    g->valid = (uint8_t)m4_mask(ok);
    u4_store(g->id, u4_all(PLT_MISS));
    if (g->valid == 0) {
        return 0;
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
    return 1;
}

static inline void compare_group(const plt_packet *p, const plt_group_rays *g, plt_common *c,
                                 f4 forward[3]) {
    m4 same = m4_bits(15);
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 dir = f4_load(g->dir[a]);
        const unsigned negative = p->slabs.negative[a] ? 15u : 0u;
        same = m4_and(same, f4_eq(f4_load(g->org[a]), f4_all(p->org[a])));
        c->other_sign[a] |= (m4_mask(f4_lt(dir, f4_zero())) ^ negative) & g->valid;
        forward[a] = f4_add(forward[a], dir);
        c->axes |= (unsigned)(g->axis_lanes[a] != 0) << a;
    }
    c->is_apart |= g->valid & ~m4_mask(same);
}

/* With the ray whose origin and signs the packet has. */
static inline void compare_groups(const plt_packet *p, plt_common *c) {
    f4 forward[3] = {f4_zero(), f4_zero(), f4_zero()};
    const plt_common none = {0, 0, {0, 0, 0}, {0.0f, 0.0f, 0.0f}};
    *c = none;
    for (plt_mask m = p->active; m != 0; m &= m - 1) {
        compare_group(p, &p->rays[plt_mask_first(m)], c, forward);
    }
    for (int a = 0; a < 3; a++) {
        float sum[4];
        f4_store(sum, forward[a]);
        c->forward[a] = sum[0];
    }
}

#endif
