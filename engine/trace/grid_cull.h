/* grid_cull - which triangles a bundle may meet, and which of its groups
 *
 * Bounds are compared with *sides*: of a triangle's box, one for each bound, moved by the turn's
 * margin. Where four lanes are one register four triangles are compared with the bounds of one
 * bundle, which are the same operations as one triangle against those of four groups.
 *
 * Source: Dmitriev, Havran, Seidel, "Faster ray tracing with SIMD shaft culling", 2004; groups are
 * ours.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_GRID_CULL_H
#define PLT_TRACE_GRID_CULL_H

#include "engine/trace/grid_state.h"
#include "engine/tree/record_rows.h"

/* Of boxes: their sides, and the depths between which they are; 0 if that is behind. */
typedef struct plt_grid_sides {
    f4 to[4], near, far;
} plt_grid_sides;

/* Where bounds are between two depths. */
static inline f4 plt_grid_least(f4 base, f4 rate, f4 near, f4 far) {
    return f4_add(base, f4_min(f4_mul(rate, near), f4_mul(rate, far)));
}

/* Those that are beyond no bound. */
static inline unsigned plt_grid_meet(const plt_grid_bounds *b, const plt_grid_sides *s) {
    m4 met = m4_bits(15);
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        const f4 least = plt_grid_least(f4_load(b->base[i]), f4_load(b->rate[i]), s->near, s->far);
        met = m4_and(met, f4_le(least, s->to[i]));
    }
    return m4_mask(met);
}

#if PLT_LANES_REGISTERS
enum { PLT_GRID_TOGETHER = 4 };

/* Points as a turn sees them: how far they reach towards each bound, moved by the margin; and how
 * deep they are. */
typedef struct plt_grid_points {
    f4 to[4], depth;
} plt_grid_points;

/* Corners of four records. */
PLT_INLINED plt_grid_points plt_grid_points_of(const plt_grid_turn *t, f4 corner[4]) {
    plt_grid_points p;
    f4_transpose(&corner[0], &corner[1], &corner[2], &corner[3]);
    p.to[0] = f4_add(corner[t->x], f4_load(t->offset[0]));
    p.to[1] = f4_add(corner[t->y], f4_load(t->offset[1]));
    p.to[2] = f4_sub(f4_load(t->offset[2]), corner[t->x]);
    p.to[3] = f4_sub(f4_load(t->offset[3]), corner[t->y]);
    p.depth = f4_mul(f4_all(t->sign), f4_sub(corner[t->z], f4_all(t->plane)));
    return p;
}

/* Triangles of which all corners are beyond one bound. */
PLT_INLINED m4 plt_grid_beside(const plt_grid_bounds *b, const plt_grid_points p[3]) {
    m4 beside = m4_bits(0);
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        const f4 base = f4_load(b->base[i]), rate = f4_load(b->rate[i]);
        m4 beyond = f4_lt(p[0].to[i], f4_add(base, f4_mul(rate, p[0].depth)));
        beyond = m4_and(beyond, f4_lt(p[1].to[i], f4_add(base, f4_mul(rate, p[1].depth))));
        beyond = m4_and(beyond, f4_lt(p[2].to[i], f4_add(base, f4_mul(rate, p[2].depth))));
        beside = m4_or(beside, beyond);
    }
    return beside;
}

/* Which of four records the bundle may meet, and the sides of their boxes. Those that are wholly
 * ahead are looked at by their corners, too: of others t may be off by so much that a hit ahead
 * belongs to a point behind. */
PLT_INLINED unsigned plt_grid_cull(const plt_grid_state *s, const plt_record *const record[4],
                                   plt_grid_sides *sides) {
    plt_grid_points p[3];
    f4 corner[3][4];
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        f4 rows[3];
        plt_record_rows(record[i], rows);
        corner[0][i] = rows[0];
        corner[1][i] = rows[1];
        corner[2][i] = rows[2];
    }
    PLT_UNROLLED for (int k = 0; k < 3; k++) {
        p[k] = plt_grid_points_of(&s->turn, corner[k]);
    }
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        sides->to[i] = f4_max(f4_max(p[0].to[i], p[1].to[i]), p[2].to[i]);
    }
    const f4 near = f4_min(f4_min(p[0].depth, p[1].depth), p[2].depth);
    const f4 far = f4_max(f4_max(p[0].depth, p[1].depth), p[2].depth);
    sides->near = f4_max(near, f4_zero());
    sides->far = f4_max(far, f4_zero());
    const unsigned met = plt_grid_meet(&s->bundle.all, sides);
    if (met == 0) {
        return 0;
    }
    return met & ~m4_mask(m4_and(plt_grid_beside(&s->bundle.all, p), f4_le(f4_zero(), near)));
}
#else
enum { PLT_GRID_TOGETHER = 1 };

/* The same of one record, a bound at a time. */
static unsigned plt_grid_cull(const plt_grid_state *s, const plt_record *const record[1],
                              plt_grid_sides *sides) {
    const plt_grid_turn *t = &s->turn;
    const plt_grid_bundle *u = &s->bundle;
    const int axis[2] = {t->x, t->y};
    float depth[3], near = PLT_BOX_FAR, far = -PLT_BOX_FAR;
    unsigned met = 1;
    for (int k = 0; k < 3; k++) {
        depth[k] = t->sign * (plt_record_float(record[0], k, t->z) - t->plane);
        near = depth[k] < near ? depth[k] : near;
        far = depth[k] > far ? depth[k] : far;
    }
    const float from = near > 0.0f ? near : 0.0f, until = far > 0.0f ? far : 0.0f;
    for (int i = 0; i < 4; i++) {
        const float at_near = u->rate[i] * from, at_far = u->rate[i] * until;
        const float up = i < 2 ? 1.0f : -1.0f;
        float side = -PLT_BOX_FAR;
        int beyond = 1;
        for (int k = 0; k < 3; k++) {
            const float corner = plt_record_float(record[0], k, axis[i & 1]);
            const float to = t->offset[i][0] + up * corner;
            side = to > side ? to : side;
            beyond &= to < u->base[i] + u->rate[i] * depth[k];
        }
        if (u->base[i] + (at_near < at_far ? at_near : at_far) > side || (beyond && near >= 0.0f)) {
            met = 0;
        }
        sides->to[i] = f4_all(side);
    }
    sides->near = f4_all(from);
    sides->far = f4_all(until);
    return met;
}
#endif

/* ---- groups ------------------------------------------------------------------------------ */

#if PLT_LANES_REGISTERS
/* Sides of four triangles become the greatest rates that bounds of one origin may have. */
PLT_INLINED void plt_grid_set_limits(const plt_grid_state *s, plt_grid_sides *sides) {
    const f4 per_near = f4_div(f4_all(1.0f), sides->near);
    const f4 per_far = f4_div(f4_all(1.0f), sides->far);
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        const f4 way = f4_sub(sides->to[i], f4_load(s->bundle.all.base[i]));
        sides->to[i] = f4_max(f4_mul(way, per_near), f4_mul(way, per_far));
    }
}

/* No rate is above its limit. */
static inline unsigned plt_grid_meet_rates(const plt_grid_bounds *b, const plt_grid_sides *limit) {
    const m4 x =
        m4_and(f4_le(f4_load(b->rate[0]), limit->to[0]), f4_le(f4_load(b->rate[2]), limit->to[2]));
    const m4 y =
        m4_and(f4_le(f4_load(b->rate[1]), limit->to[1]), f4_le(f4_load(b->rate[3]), limit->to[3]));
    return m4_mask(m4_and(x, y));
}

/* Those of `groups` that may meet a triangle whose limits are in all lanes. Quads are not asked:
 * how many there are cannot be foreseen, and that costs more than their groups do. */
PLT_INLINED plt_mask plt_grid_meet_limits(const plt_grid_state *s, const plt_grid_sides *limit,
                                          plt_mask groups) {
    enum { QUADS = PLT_GRID_QUADS < 4 ? PLT_GRID_QUADS : 4 }; /* of a sixteen */
    plt_mask met = 0;
    unsigned sixteens = PLT_GRID_SIXTEENS > 1 ? plt_grid_meet_rates(&s->sixteen, limit) : 1;
    for (; sixteens != 0; sixteens &= sixteens - 1) {
        const unsigned i = (unsigned)__builtin_ctz(sixteens);
        PLT_UNROLLED for (unsigned k = 0; k < QUADS; k++) {
            const unsigned quad = 4 * i + k;
            met |= (plt_mask)plt_grid_meet_rates(&s->group[quad], limit) << (4 * quad);
        }
    }
    return met & groups;
}
#define PLT_GRID_PART PLT_INLINED
#else
#define PLT_GRID_PART static
#endif

/* ... whose sides are. */
PLT_GRID_PART plt_mask plt_grid_meet_groups(const plt_grid_state *s, const plt_grid_sides *of,
                                            plt_mask groups) {
    plt_mask met = 0;
    unsigned sixteens = PLT_GRID_SIXTEENS > 1 ? plt_grid_meet(&s->sixteen, of) : 1;
    for (; sixteens != 0; sixteens &= sixteens - 1) {
        const unsigned i = (unsigned)__builtin_ctz(sixteens);
        if ((groups >> (16 * i) & 0xFFFFu) == 0) {
            continue;
        }
        for (unsigned quads = plt_grid_meet(&s->quad[i], of); quads != 0; quads &= quads - 1) {
            const unsigned quad = 4 * i + (unsigned)__builtin_ctz(quads);
            met |= (plt_mask)plt_grid_meet(&s->group[quad], of) << (4 * quad);
        }
    }
    return met & groups;
}

#endif
