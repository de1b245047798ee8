/* grid_cull - which groups of a bundle may meet a triangle
 *
 * Source: Dmitriev, Havran, Seidel, "Faster ray tracing with SIMD shaft culling", 2004; groups are
 * ours.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_GRID_CULL_H
#define PLT_TRACE_GRID_CULL_H

#include "engine/trace/grid_state.h"

/* A triangle as a turn sees it. */
typedef struct plt_grid_shape {
    float corner[3][4]; /* relative to the scene's least corner */
    float lo[4], hi[4];
    float near, far; /* depths */
} plt_grid_shape;

static inline void plt_grid_shape_set(plt_grid_shape *g, const plt_grid_turn *t,
                                      const plt_box *scene, const f4 corner[3]) {
    const f4 lo = f4_load(scene->lo); /* and a number behind it */
    const f4 a = f4_sub(corner[0], lo), b = f4_sub(corner[1], lo), c = f4_sub(corner[2], lo);
    const float plane = t->plane - scene->lo[t->z];
    f4_store(&g->corner[0][0], a);
    f4_store(&g->corner[1][0], b);
    f4_store(&g->corner[2][0], c);
    f4_store(g->lo, f4_min(f4_min(a, b), c));
    f4_store(g->hi, f4_max(f4_max(a, b), c));
    const int up = t->sign > 0.0f;
    g->near = up ? g->lo[t->z] - plane : plane - g->hi[t->z];
    g->far = up ? g->hi[t->z] - plane : plane - g->lo[t->z];
}

/* Where bounds are between two depths, at least. */
static inline f4 plt_grid_least(f4 base, f4 rate, f4 near, f4 far) {
    return f4_add(base, f4_min(f4_mul(rate, near), f4_mul(rate, far)));
}

/* All corners are beyond one bound. Only of a triangle that is wholly ahead: t may be off by so
 * much that a hit ahead belongs to a point behind. */
static inline int plt_grid_is_beside(const plt_grid_bundle *u, const plt_grid_turn *t,
                                     const plt_grid_shape *g) {
    const f4 base = f4_sub(f4_load(u->base), f4_all(t->margin)), rate = f4_load(u->rate);
    const float plane = t->sign > 0.0f ? g->near - g->lo[t->z] : g->near + g->hi[t->z];
    m4 beyond = m4_bits(15);
    if (!(g->near >= 0.0f)) {
        return 0;
    }
    PLT_UNROLLED for (int i = 0; i < 3; i++) {
        const float x = g->corner[i][t->x], y = g->corner[i][t->y];
        const float depth = t->sign * g->corner[i][t->z] + plane;
        const f4 at = plt_grid_four(x, y, -x, -y);
        beyond = m4_and(beyond, f4_lt(at, f4_add(base, f4_mul(rate, f4_all(depth)))));
    }
    return m4_mask(beyond) != 0;
}

/* The four sides of a triangle's box, each in all lanes. */
typedef struct plt_grid_sides {
    f4 side[4], near, far;
} plt_grid_sides;

/* Of four groups, or quads. */
static inline unsigned plt_grid_meet(const plt_grid_bounds *b, const plt_grid_sides *g) {
    m4 met = m4_bits(15);
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        const f4 least = plt_grid_least(f4_load(b->base[i]), f4_load(b->rate[i]), g->near, g->far);
        met = m4_and(met, f4_le(least, g->side[i]));
    }
    return m4_mask(met);
}

static inline plt_mask plt_grid_meet_groups(const plt_grid_state *s, const plt_grid_sides *g,
                                            plt_mask groups) {
    plt_mask met = 0;
    for (unsigned i = 0; i < PLT_GRID_SIXTEENS; i++) {
        if ((groups >> (16 * i) & 0xFFFFu) == 0) {
            continue;
        }
        for (unsigned m = plt_grid_meet(&s->quad[i], g); m != 0; m &= m - 1) {
            const unsigned quad = 4 * i + (unsigned)__builtin_ctz(m);
            if ((groups >> (4 * quad) & 15u) != 0) {
                met |= (plt_mask)plt_grid_meet(&s->group[quad], g) << (4 * quad);
            }
        }
    }
    return met & groups;
}

/* Those of `groups`, of the bundle, that may meet it. */
static inline plt_mask plt_grid_cull(const plt_grid_state *s, const plt_grid_shape *g,
                                     plt_mask groups) {
    const plt_grid_turn *t = &s->turn;
    const float near = g->near > 0.0f ? g->near : 0.0f, far = g->far > 0.0f ? g->far : 0.0f;
    const float side[4] = {g->hi[t->x] + t->margin, g->hi[t->y] + t->margin,
                           t->margin - g->lo[t->x], t->margin - g->lo[t->y]};
    const f4 least =
        plt_grid_least(f4_load(s->bundle.base), f4_load(s->bundle.rate), f4_all(near), f4_all(far));
    if (m4_mask(f4_le(least, f4_load(side))) != 15 || plt_grid_is_beside(&s->bundle, t, g)) {
        return 0;
    }
    if ((groups & (groups - 1)) == 0 || (s->without & PLT_GRID_WITHOUT_GROUPS) != 0) {
        return groups;
    }
    plt_grid_sides sides;
    sides.near = f4_all(near);
    sides.far = f4_all(far);
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        sides.side[i] = f4_all(side[i]);
    }
    return plt_grid_meet_groups(s, &sides, groups);
}

#endif
