/* hulls - see hulls.h
 *
 * First the intervals of slopes and origins are collected from the groups upwards, in the rows
 * that later hold rates and moved origins; then each hull is converted.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/hulls.h"

#include "engine/trace/ray_bounds.h"
#include "engine/trace/triangle_common.h"

#if PLT_WITH_HULLS

_Static_assert(sizeof(plt_hull) == PLT_HULL_BYTES, "as packet.h has it");

#define SLOPE_LEAST 8.67361738e-19f     /* 2^-60: a smaller one is as good as none ... */
#define SLOPE_FLAT 3.46944695e-18f      /* ... and 2^-58 is more than any that was made larger */
#define DEPTH_SHORT 0.99999905f         /* 1 - 2^-20 */
#define DEPTH_LONG 1.00000095f          /* 1 + 2^-20 */
#define DEPTH_TINY 8.2718061255303e-25f /* 2^-80, for what underflows */
#define SMALL 0.25f                     /* of a box beside a lane: refine it */

/* Least and greatest lane of four rows, a lane for each row. */
static inline f4 least_of(f4 a, f4 b, f4 c, f4 d) {
    f4_transpose(&a, &b, &c, &d);
    return f4_min(f4_min(a, b), f4_min(c, d));
}

static inline f4 most_of(f4 a, f4 b, f4 c, f4 d) {
    f4_transpose(&a, &b, &c, &d);
    return f4_max(f4_max(a, b), f4_max(c, d));
}

static inline void collect(f4 row[4], float *least, float *most) {
    f4_transpose(&row[0], &row[1], &row[2], &row[3]);
    f4_store(least, f4_min(f4_min(row[0], row[1]), f4_min(row[2], row[3])));
    f4_store(most, f4_max(f4_max(row[0], row[1]), f4_max(row[2], row[3])));
}

/* How far along the packet's axis a group still seeks hits. */
static inline f4 group_depth(const plt_packet *p, unsigned group, const float t[4]) {
    return f4_mul(f4_load(t), f4_abs(f4_load(p->rays[group].dir[p->axis])));
}

static inline f4 deepest(const plt_packet *p, unsigned first) {
    const plt_group_slabs *s = &p->slabs.group[first];
    const f4 most =
        most_of(group_depth(p, first, s[0].tmax), group_depth(p, first + 1, s[1].tmax),
                group_depth(p, first + 2, s[2].tmax), group_depth(p, first + 3, s[3].tmax));
    return f4_add(f4_mul(most, f4_all(DEPTH_LONG)), f4_all(DEPTH_TINY));
}

/* None is below 0: a bound behind the origin is none. */
static inline f4 shallowest(const plt_packet *p, unsigned first) {
    const plt_group_slabs *s = &p->slabs.group[first];
    const f4 least =
        least_of(group_depth(p, first, s[0].tmin), group_depth(p, first + 1, s[1].tmin),
                 group_depth(p, first + 2, s[2].tmin), group_depth(p, first + 3, s[3].tmin));
    return f4_max(f4_sub(f4_mul(least, f4_all(DEPTH_SHORT)), f4_all(DEPTH_TINY)), f4_zero());
}

/* Lanes from groups that all have rays. */
PLT_INLINED void collect_groups(const plt_packet *p, plt_hull *h, unsigned first,
                                enum plt_coherence kind) {
    const plt_group_rays *g = &p->rays[first];
    const int x = plt_axis_after[p->axis], y = plt_axis_after[x];
    f4 row[4];
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        row[i] = f4_load(g[i].slope[0]);
    }
    collect(row, h->far_rate[x], h->slabs.rdir[x]);
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        row[i] = f4_load(g[i].slope[1]);
    }
    collect(row, h->far_rate[y], h->slabs.rdir[y]);
    if (kind != PLT_ONE_ORIGIN) {
        PLT_UNROLLED for (int a = 0; a < 3; a++) {
            PLT_UNROLLED for (int i = 0; i < 4; i++) {
                row[i] = f4_load(g[i].org[a]);
            }
            collect(row, h->slabs.far_org[a], h->slabs.near_org[a]);
        }
    }
    if (!p->unbounded) {
        f4_store(h->slabs.tmin, shallowest(p, first));
        f4_store(h->slabs.tmax, deepest(p, first));
    }
}

/* A group without a ray: nothing that a hull would have to reach around. */
static void set_nothing(plt_packet *p, unsigned group) {
    plt_group_rays *g = &p->rays[group];
    const unsigned copied = plt_mask_first(p->active);
    for (int a = 0; a < 3; a++) {
        f4_store(g->org[a], f4_load(p->rays[copied].org[a]));
        f4_store(g->dir[a], f4_load(p->rays[copied].dir[a]));
    }
    f4_store(g->slope[0], f4_load(p->rays[copied].slope[0]));
    f4_store(g->slope[1], f4_load(p->rays[copied].slope[1]));
    f4_store(p->slabs.group[group].tmin, f4_all(1.0f));
    f4_store(p->slabs.group[group].tmax, f4_all(-1.0f));
}

/* `of`, least_of or most_of, a row of four hulls. */
#define OF_FOUR(of, hull, row)                                                                     \
    of(f4_load((hull)[0].row), f4_load((hull)[1].row), f4_load((hull)[2].row),                     \
       f4_load((hull)[3].row))

/* Lanes from the four hulls below. */
PLT_INLINED void collect_hulls(const plt_packet *p, plt_hull *h, const plt_hull *below,
                               enum plt_coherence kind) {
    for (int a = 0; a < 3; a++) {
        if (a != p->axis) {
            f4_store(h->far_rate[a], OF_FOUR(least_of, below, far_rate[a]));
            f4_store(h->slabs.rdir[a], OF_FOUR(most_of, below, slabs.rdir[a]));
        }
        if (kind != PLT_ONE_ORIGIN) {
            f4_store(h->slabs.far_org[a], OF_FOUR(least_of, below, slabs.far_org[a]));
            f4_store(h->slabs.near_org[a], OF_FOUR(most_of, below, slabs.near_org[a]));
        }
    }
    if (!p->unbounded) {
        f4_store(h->slabs.tmin, OF_FOUR(least_of, below, slabs.tmin));
        f4_store(h->slabs.tmax, OF_FOUR(most_of, below, slabs.tmax));
    }
}

static inline f4 rate(float sign, f4 slope, float least) {
    return f4_div(f4_all(sign), f4_max(slope, f4_all(least)));
}

/* Rates along an axis across the packet's, from the interval of slopes, whose signs are equal. */
static inline void convert_slopes(const plt_packet *p, plt_hull *h, int axis) {
    const f4 lo = f4_abs(f4_load(h->far_rate[axis])), hi = f4_abs(f4_load(h->slabs.rdir[axis]));
    const float sign = p->slabs.negative[axis] ? -1.0f : 1.0f;
    f4_store(h->slabs.rdir[axis], rate(sign, f4_max(lo, hi), SLOPE_FLAT));
    f4_store(h->far_rate[axis], rate(sign, f4_min(lo, hi), SLOPE_LEAST));
}

/* ... whatever their signs are. */
static void convert_mixed_slopes(const plt_packet *p, plt_hull *h, int axis) {
    const int back = p->slabs.negative[p->axis];
    const f4 lo = f4_load(h->far_rate[axis]), hi = f4_load(h->slabs.rdir[axis]);
    const f4 from = back ? f4_neg(hi) : lo, to = back ? f4_neg(lo) : hi;
    const m4 ups = f4_le(f4_zero(), to), downs = f4_lt(from, f4_zero());
    const f4 up = rate(1.0f, to, SLOPE_FLAT), down = rate(-1.0f, f4_neg(from), SLOPE_FLAT);
    const f4 up_far = rate(1.0f, from, SLOPE_LEAST);
    const f4 down_far = rate(-1.0f, f4_neg(to), SLOPE_LEAST);
    f4_store(h->slabs.rdir[axis], f4_select(ups, up, f4_zero()));
    f4_store(h->back_rate[axis], f4_select(downs, down, f4_zero()));
    f4_store(h->far_rate[axis],
             f4_select(m4_and(ups, downs), f4_zero(), f4_select(downs, down_far, up_far)));
}

/* Along the packet's axis depth is distance. */
PLT_INLINED void set_along(const plt_packet *p, plt_hull *h, enum plt_coherence kind) {
    const int back = p->slabs.negative[p->axis];
    const f4 along = f4_all(back ? -1.0f : 1.0f);
    f4_store(h->slabs.rdir[p->axis], kind == PLT_MIXED && back ? f4_zero() : along);
    f4_store(h->far_rate[p->axis], along);
    if (kind == PLT_MIXED) {
        f4_store(h->back_rate[p->axis], back ? along : f4_zero());
    }
}

PLT_INLINED void convert_origins(const plt_packet *p, plt_hull *h, int axis, float error,
                                 enum plt_coherence kind) {
    const f4 up = f4_add(f4_load(h->slabs.near_org[axis]), f4_all(error));
    const f4 down = f4_sub(f4_load(h->slabs.far_org[axis]), f4_all(error));
    const int swap = kind != PLT_MIXED && p->slabs.negative[axis];
    f4_store(h->slabs.near_org[axis], swap ? down : up);
    f4_store(h->slabs.far_org[axis], swap ? up : down);
}

static inline f4 extent(const float to[4], const float from[4]) {
    return f4_sub(f4_load(to), f4_load(from));
}

PLT_INLINED void convert(const plt_packet *p, plt_hull *h, const float error[3],
                         enum plt_coherence kind) {
    const int z = p->axis, x = plt_axis_after[z], y = plt_axis_after[x];
    const f4 slopes =
        f4_max(extent(h->slabs.rdir[x], h->far_rate[x]), extent(h->slabs.rdir[y], h->far_rate[y]));
    f4_store(h->narrow[0], f4_mul(slopes, f4_all(SMALL)));
    if (p->unbounded) {
        f4_store(h->slabs.tmin, f4_zero());
        f4_store(h->slabs.tmax, f4_all(__builtin_inff()));
    }
    if (kind == PLT_MIXED) {
        convert_mixed_slopes(p, h, x);
        convert_mixed_slopes(p, h, y);
    } else {
        convert_slopes(p, h, x);
        convert_slopes(p, h, y);
    }
    set_along(p, h, kind);
    if (kind == PLT_ONE_ORIGIN) {
        f4_store(h->narrow[1], f4_zero());
        return;
    }
    const f4 origins = f4_max(extent(h->slabs.near_org[x], h->slabs.far_org[x]),
                              extent(h->slabs.near_org[y], h->slabs.far_org[y]));
    f4_store(h->narrow[1], f4_mul(origins, f4_all(SMALL)));
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        convert_origins(p, h, a, error[a], kind);
    }
}

static inline float larger(float a, float b) {
    return a > b ? a : b;
}

/* How far origins are moved (ray_bounds.h), by a reach that is enough for all rays, and what
 * it makes of edge functions. */
static void set_reach(plt_packet *p, float error[3]) {
    const plt_group_slabs *s = &p->hull[0].slabs;
    float reach = PLT_REACH_LEAST, furthest[3];
    for (int a = 0; a < 3; a++) {
        const float end[2] = {f4_min_lane(f4_load(s->far_org[a])),
                              -f4_min_lane(f4_neg(f4_load(s->near_org[a])))};
        for (int i = 0; i < 2; i++) {
            reach = larger(reach, __builtin_fabsf(p->scene->lo[a] - end[i]));
            reach = larger(reach, __builtin_fabsf(p->scene->hi[a] - end[i]));
        }
        furthest[a] = larger(-end[0], end[1]);
    }
    plt_packet_set_reach(p, reach * PLT_REACH_ROUNDING,
                         larger(larger(furthest[0], furthest[1]), furthest[2]));
    for (int a = 0; a < 3; a++) {
        error[a] = larger(p->reach * PLT_BOX_ERROR, furthest[a] * PLT_ORIGIN_ERROR);
    }
}

PLT_INLINED void set_kind(plt_packet *p, enum plt_coherence kind) {
    const unsigned lowest = (p->first_group - 1) / 4; /* hulls of groups begin here */
    float error[3] = {0.0f, 0.0f, 0.0f};
    for (unsigned i = 0; i < p->capacity; i += 4) {
        collect_groups(p, &p->hull[lowest + i / 4], i, kind);
    }
    for (unsigned i = lowest; i-- > 0;) {
        collect_hulls(p, &p->hull[i], &p->hull[plt_hull_below(i, 0)], kind);
    }
    if (kind != PLT_ONE_ORIGIN) {
        set_reach(p, error);
    }
    for (unsigned i = 0; i < p->first_group; i++) {
        convert(p, &p->hull[i], error, kind);
    }
}

void plt_hulls_set(plt_packet *p) {
    p->changed = 0;
    p->moved = p->slabs.coherence == PLT_ONE_ORIGIN;
    for (int a = 0; a < 4; a++) {
        p->across[a] = a < 3 && a != p->axis ? 1.0f : 0.0f;
    }
    if (p->first_group == 0) {
        plt_packet_make_ready(p); /* the reach of all four */
        return;
    }
    const plt_mask all = ~(plt_mask)0 >> (8 * sizeof(plt_mask) - p->capacity);
    p->unbounded &= p->active == all;
    for (plt_mask m = all & ~p->active; m != 0; m &= m - 1) {
        set_nothing(p, plt_mask_first(m));
    }
    switch (p->slabs.coherence) {
    case PLT_ONE_ORIGIN:
        set_kind(p, PLT_ONE_ORIGIN);
        break;
    case PLT_ONE_SIGN:
        set_kind(p, PLT_ONE_SIGN);
        break;
    default:
        set_kind(p, PLT_MIXED);
        break;
    }
}

void plt_hulls_narrow(plt_packet *p) {
    plt_mask hulls = 0; /* whose lanes must be taken anew, a bit each */
    if (p->first_group == 0) {
        return; /* 2 x 2 rays are a group, and have none */
    }
    for (plt_mask m = p->changed; m != 0; m &= m - 1) {
        hulls |= plt_mask_of((plt_mask_first(m) + p->first_group - 1) / 4, 1);
    }
    p->changed = 0;
    const unsigned lowest = (p->first_group - 1) / 4;
    while (hulls != 0) {
        const unsigned i = plt_mask_last(hulls);
        hulls ^= plt_mask_of(i, 1);
        if (i >= lowest) {
            f4_store(p->hull[i].slabs.tmax, deepest(p, 4 * (i - lowest)));
        } else {
            const plt_hull *below = &p->hull[plt_hull_below(i, 0)];
            f4_store(p->hull[i].slabs.tmax, OF_FOUR(most_of, below, slabs.tmax));
        }
        if (i > 0) {
            hulls |= plt_mask_of((i - 1) / 4, 1);
        }
    }
}

#endif
