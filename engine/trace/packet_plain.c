/* packet_plain - see packet_plain.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/packet_plain.h"

#include "engine/trace/ray_bounds.h"

#if PLT_WITH_HULLS

/* Of rays' org and tmin, or dir and tmax, which lie side by side. */
typedef struct extent {
    f4 least, most, sum;
} extent;

typedef struct extents {
    extent org, dir;
} extents;

static inline void add(extent *e, f4 v) {
    e->least = f4_min(e->least, v);
    e->most = f4_max(e->most, v);
    e->sum = f4_add(e->sum, v); /* a NaN stays in it */
}

static inline const float *org_of(const plt_ray *ray) {
    return (const float *)ray; /* org tmin dir tmax, without gaps */
}

static inline const float *dir_of(const plt_ray *ray) {
    return org_of(ray) + 4;
}

/* `count`: a multiple of 4. */
static extents extents_of(const plt_ray *rays, uint32_t count) {
    const f4 org = f4_load(org_of(rays)), dir = f4_load(dir_of(rays));
    extents e = {{org, org, f4_zero()}, {dir, dir, f4_zero()}};
    for (uint32_t i = 0; i < count; i += 4) {
        PLT_UNROLLED for (uint32_t k = 0; k < 4; k++) {
            add(&e.org, f4_load(org_of(&rays[i + k])));
            add(&e.dir, f4_load(dir_of(&rays[i + k])));
        }
    }
    return e;
}

/* The greatest size of each component, and what none is below (negative where there are both
 * signs). */
static inline f4 largest(const extent *e) {
    return f4_max(f4_neg(e->least), e->most);
}

static inline f4 smallest(const extent *e) {
    return f4_max(e->least, f4_neg(e->most));
}

enum { X_Y_Z = 7 }; /* lanes */

/* None is refused (packet_set.c), if the axis of the largest component is long enough. */
static int are_rays(const extents *e) {
    const m4 numbers = m4_and(f4_eq(e->org.sum, e->org.sum), f4_eq(e->dir.sum, e->dir.sum));
    const m4 within = m4_and(f4_le(largest(&e->org), f4_all(PLT_COORD_MAX)),
                             f4_le(largest(&e->dir), f4_all(PLT_DIR_MOST)));
    const m4 ranges = m4_and(f4_le(e->org.most, e->dir.least), f4_le(f4_zero(), e->dir.least));
    return m4_mask(numbers) == 15 && (m4_mask(within) & X_Y_Z) == X_Y_Z &&
           (m4_mask(ranges) & 8u) != 0;
}

/* The axis that is the largest of every direction, the first of equals; or PLT_AXES_DIFFER. */
static uint8_t axis_of(const extents *e) {
    float least[4], most[4];
    f4_store(least, smallest(&e->dir));
    f4_store(most, largest(&e->dir));
    if (least[0] >= most[1] && least[0] >= most[2]) {
        return least[0] >= PLT_DIR_LEAST ? 0 : PLT_AXES_DIFFER;
    }
    if (least[1] > most[0] && least[1] >= most[2]) {
        return least[1] >= PLT_DIR_LEAST ? 1 : PLT_AXES_DIFFER;
    }
    return least[2] > most[0] && least[2] > most[1] && least[2] >= PLT_DIR_LEAST ? 2
                                                                                 : PLT_AXES_DIFFER;
}

/* Four rays that are plain, with their largest components along axis z. */
PLT_INLINED void set_group(plt_group_slabs *s, plt_group_rays *g, const plt_ray rays[4], int z) {
    const int x = z == 2 ? 0 : z + 1, y = z == 0 ? 2 : z - 1;
    f4 org[4], dir[4];
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        org[i] = f4_load(org_of(&rays[i]));
        dir[i] = f4_load(dir_of(&rays[i]));
    }
    f4_transpose(&org[0], &org[1], &org[2], &org[3]);
    f4_transpose(&dir[0], &dir[1], &dir[2], &dir[3]);
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        f4_store(g->org[a], org[a]);
        f4_store(g->dir[a], dir[a]);
        g->axis_lanes[a] = a == z ? 15 : 0;
    }
    g->valid = 15;
    f4_store(g->slope[0], f4_div(dir[x], dir[z]));
    f4_store(g->slope[1], f4_div(dir[y], dir[z]));
    f4_store(s->tmin, f4_max(org[3], f4_zero()));
    f4_store(s->tmax, dir[3]);
    u4_store(g->id, u4_all(PLT_MISS));
}

/* While they are set up, as many rays behind them are asked for (rays.c). */
PLT_INLINED void set_groups(plt_packet *p, const plt_ray *rays, uint32_t count, int z) {
    const uintptr_t ahead = count * sizeof *rays;
    plt_group_slabs *s = p->slabs.group;
    plt_group_rays *g = p->rays;
    for (const plt_ray *const end = rays + count; rays < end; rays += 4) {
        plt_prefetch((const void *)((uintptr_t)rays + ahead));
        plt_prefetch((const void *)((uintptr_t)rays + ahead + 2 * sizeof *rays));
        set_group(s++, g++, rays, z);
    }
}

static plt_common common_of(const extents *e, uint8_t axis) {
    const m4 one_origin = f4_eq(e->org.least, e->org.most);
    const m4 both = m4_and(f4_lt(e->dir.least, f4_zero()), f4_le(f4_zero(), e->dir.most));
    const unsigned signs = m4_mask(both);
    float sum[4];
    f4_store(sum, e->dir.sum);
    const plt_common c = {(m4_mask(one_origin) & X_Y_Z) != X_Y_Z,
                          1u << axis,
                          {signs & 1u, signs & 2u, signs & 4u},
                          {sum[0], sum[1], sum[2]}};
    return c;
}

/* All seek hits anywhere ahead. */
static uint8_t is_unbounded(const extents *e) {
    const m4 ahead =
        m4_and(f4_le(e->org.most, f4_zero()), f4_le(f4_all(__builtin_inff()), e->dir.least));
    return (m4_mask(ahead) & 8u) != 0;
}

int plt_packet_set_plain(plt_packet *p, const plt_ray *rays, uint32_t count) {
    if (count == 0 || count % 4 != 0) {
        return 0;
    }
    const extents e = extents_of(rays, count);
    const uint8_t axis = are_rays(&e) ? axis_of(&e) : PLT_AXES_DIFFER;
    switch (axis) {
    case 0:
        set_groups(p, rays, count, 0);
        break;
    case 1:
        set_groups(p, rays, count, 1);
        break;
    case 2:
        set_groups(p, rays, count, 2);
        break;
    default:
        return 0;
    }
    const plt_common common = common_of(&e, axis);
    p->unbounded = is_unbounded(&e);
    p->active = ~(plt_mask)0 >> (8 * sizeof p->active - count / 4);
    plt_packet_share(p, &common);
    return 1;
}

#endif
