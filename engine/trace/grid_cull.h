/* grid_cull - which groups of a bundle may meet a triangle
 *
 * Source: Dmitriev, Havran, Seidel, "Faster ray tracing with SIMD shaft culling", 2004; groups are
 * ours.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_GRID_CULL_H
#define PLT_TRACE_GRID_CULL_H

#include "engine/trace/grid_state.h"

/* A triangle, relative to the scene's least corner; the fourth lane means nothing. */
typedef struct plt_grid_shape {
    f4 corner[3], lo, hi;
} plt_grid_shape;

static inline plt_grid_shape plt_grid_shape_of(const plt_box *scene, const f4 corner[3]) {
    const f4 lo = f4_load(scene->lo); /* and a number behind it */
    plt_grid_shape g;
    PLT_UNROLLED for (int i = 0; i < 3; i++) {
        g.corner[i] = f4_sub(corner[i], lo);
    }
    g.lo = f4_min(f4_min(g.corner[0], g.corner[1]), g.corner[2]);
    g.hi = f4_max(f4_max(g.corner[0], g.corner[1]), g.corner[2]);
    return g;
}

/* How deep a point lies, in all lanes. */
static inline f4 plt_grid_depth(const plt_grid_turn *t, float plane, f4 at) {
    float axes[4];
    f4_store(axes, at);
    return f4_all(t->sign * (axes[t->z] - plane));
}

/* Where bounds are between two depths. */
static inline f4 plt_grid_least(f4 base, f4 rate, f4 near, f4 far) {
    return f4_add(base, f4_min(f4_mul(rate, near), f4_mul(rate, far)));
}

static inline f4 plt_grid_most(f4 base, f4 rate, f4 near, f4 far) {
    return f4_add(base, f4_max(f4_mul(rate, near), f4_mul(rate, far)));
}

enum { PLT_GRID_AXES = 7 }; /* lanes */

static inline int plt_grid_on_all_axes(m4 a) {
    return (m4_mask(a) & PLT_GRID_AXES) == PLT_GRID_AXES;
}

/* All corners are beyond one bound. Only of a triangle that is wholly ahead: t may be off by so
 * much that a hit ahead belongs to a point behind. */
static inline int plt_grid_is_beside(const plt_grid_frustum *f, const plt_grid_turn *t,
                                     const plt_grid_shape *g, float plane) {
    m4 below = m4_bits(15), above = below;
    PLT_UNROLLED for (int i = 0; i < 3; i++) {
        const f4 at = g->corner[i], depth = plt_grid_depth(t, plane, at);
        const f4 least = f4_add(f4_load(f->least), f4_mul(f4_load(f->least_rate), depth));
        const f4 most = f4_add(f4_load(f->most), f4_mul(f4_load(f->most_rate), depth));
        below = m4_and(below, f4_lt(at, least));
        above = m4_and(above, f4_lt(most, at));
    }
    return (m4_mask(m4_or(below, above)) & PLT_GRID_AXES) != 0;
}

/* A number per bound, in all lanes. */
typedef struct plt_grid_limits {
    f4 bound[4];
} plt_grid_limits;

/* `below` and `above`: an axis per lane. */
static inline plt_grid_limits plt_grid_limits_of(const plt_grid_turn *t, f4 below, f4 above) {
    float hi[4], lo[4];
    f4_store(hi, below);
    f4_store(lo, f4_neg(above));
    const plt_grid_limits l = {
        {f4_all(hi[t->x]), f4_all(hi[t->y]), f4_all(lo[t->x]), f4_all(lo[t->y])}};
    return l;
}

/* Of four groups, or quads, or sixteens: those whose bounds meet a box whose sides are the limits,
 * between two depths. */
static inline unsigned plt_grid_meet(const plt_grid_bounds *b, const plt_grid_limits *side, f4 near,
                                     f4 far) {
    m4 met = m4_bits(15);
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        const f4 least = plt_grid_least(f4_load(b->base[i]), f4_load(b->rate[i]), near, far);
        met = m4_and(met, f4_le(least, side->bound[i]));
    }
    return m4_mask(met);
}

/* The same of rays of one origin: no rate is above a limit. */
static inline unsigned plt_grid_meet_rates(const plt_grid_bounds *b, const plt_grid_limits *rate) {
    const m4 x = m4_and(f4_le(f4_load(b->rate[0]), rate->bound[0]),
                        f4_le(f4_load(b->rate[2]), rate->bound[2]));
    const m4 y = m4_and(f4_le(f4_load(b->rate[1]), rate->bound[1]),
                        f4_le(f4_load(b->rate[3]), rate->bound[3]));
    return m4_mask(m4_and(x, y));
}

/* `meet`(bounds): which of four. */
#define PLT_GRID_MEET_GROUPS(s, groups, met, meet)                                                 \
    unsigned sixteens = PLT_GRID_SIXTEENS > 1 ? meet(&(s)->sixteen) : 1;                           \
    for (; sixteens != 0; sixteens &= sixteens - 1) {                                              \
        const unsigned i = (unsigned)__builtin_ctz(sixteens);                                      \
        if (((groups) >> (16 * i) & 0xFFFFu) == 0) {                                               \
            continue;                                                                              \
        }                                                                                          \
        for (unsigned m = meet(&(s)->quad[i]); m != 0; m &= m - 1) {                               \
            const unsigned quad = 4 * i + (unsigned)__builtin_ctz(m);                              \
            if (((groups) >> (4 * quad) & 15u) != 0) {                                             \
                (met) |= (plt_mask)meet(&(s)->group[quad]) << (4 * quad);                          \
            }                                                                                      \
        }                                                                                          \
    }

/* A triangle that is well ahead of the rays' one origin: those groups that have slopes towards its
 * box. */
static inline plt_mask plt_grid_cull_slopes(const plt_grid_state *s, const plt_grid_shape *g,
                                            f4 near, f4 far, float plane, plt_mask groups) {
    const plt_grid_frustum *f = &s->bundle.frustum;
    const f4 per_near = f4_div(f4_all(1.0f), near), per_far = f4_div(f4_all(1.0f), far);
    const f4 hi = f4_sub(g->hi, f4_load(f->least)), lo = f4_sub(g->lo, f4_load(f->most));
    const f4 below = f4_max(f4_mul(hi, per_near), f4_mul(hi, per_far));
    const f4 above = f4_min(f4_mul(lo, per_near), f4_mul(lo, per_far));
    if (!plt_grid_on_all_axes(
            m4_and(f4_le(f4_load(f->least_rate), below), f4_le(above, f4_load(f->most_rate)))) ||
        plt_grid_is_beside(f, &s->turn, g, plane)) {
        return 0;
    }
    if ((groups & (groups - 1)) == 0 || (s->without & PLT_GRID_WITHOUT_GROUPS) != 0) {
        return groups;
    }
    const plt_grid_limits rate = plt_grid_limits_of(&s->turn, below, above);
    plt_mask met = 0;
#define MEET(bounds) plt_grid_meet_rates(bounds, &rate)
    PLT_GRID_MEET_GROUPS(s, groups, met, MEET)
#undef MEET
    return met & groups;
}

/* Those of `groups`, of the bundle, that may meet it. */
static inline plt_mask plt_grid_cull(const plt_grid_state *s, const plt_box *scene,
                                     const plt_grid_shape *g, plt_mask groups) {
    const plt_grid_turn *t = &s->turn;
    const plt_grid_frustum *f = &s->bundle.frustum;
    const float plane = t->plane - scene->lo[t->z];
    const f4 one = plt_grid_depth(t, plane, g->lo), other = plt_grid_depth(t, plane, g->hi);
    if (m4_mask(f4_le(f4_all(t->close), f4_min(one, other))) != 0) {
        return plt_grid_cull_slopes(s, g, one, other, plane, groups);
    }
    const f4 near = f4_max(one, f4_zero()), far = f4_max(other, f4_zero());
    const f4 least = plt_grid_least(f4_load(f->least), f4_load(f->least_rate), near, far);
    const f4 most = plt_grid_most(f4_load(f->most), f4_load(f->most_rate), near, far);
    if (!plt_grid_on_all_axes(m4_and(f4_le(least, g->hi), f4_le(g->lo, most)))) {
        return 0;
    }
    const int is_ahead = m4_mask(f4_le(f4_zero(), f4_min(one, other))) != 0;
    if (is_ahead && plt_grid_is_beside(f, t, g, plane)) {
        return 0;
    }
    if ((groups & (groups - 1)) == 0 || (s->without & PLT_GRID_WITHOUT_GROUPS) != 0) {
        return groups;
    }
    const f4 margin = f4_all(t->margin);
    const plt_grid_limits side =
        plt_grid_limits_of(t, f4_add(g->hi, margin), f4_sub(g->lo, margin));
    plt_mask met = 0;
#define MEET(bounds) plt_grid_meet(bounds, &side, near, far)
    PLT_GRID_MEET_GROUPS(s, groups, met, MEET)
#undef MEET
    return met & groups;
}

#endif
