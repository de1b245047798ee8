/* wave_binary - a ray in flight over a tree of two children per node
 *
 * A node gives its children six planes, and each one belongs to one of them. Beside it a child
 * has its parent's, so the interval in which a ray is in the child is that in its parent, cut
 * by the planes that are the child's own: near planes of a child lie within those of its
 * parent, and distances are monotone (DESIGN.md, section 7.3), so that the greatest of them is
 * the same number as over all six of the child's box. Six distances instead of twelve.
 *
 * Source: Karrenberg 2007, section 3.5 (intervals); the wave is ours.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WAVE_BINARY_H
#define PLT_TRACE_WAVE_BINARY_H

#include <string.h>

#include "engine/base/box.h"
#include "engine/lanes/lanes.h"
#include "engine/trace/wave_state.h"

#define PLT_ENDLESS __builtin_inff()

/* In pairs: where the ray enters a box, and minus where it leaves it, so that greater is narrower.
 */
typedef struct plt_binary_ray {
    plt_wave_ray ray;
    float near_org[4], far_org[4], rdir[4]; /* x y z; the fourth means nothing */
    float range[4];                         /* tmin, minus tmax, twice */
    uint32_t negative;                      /* signs of dir, as owner bits */
    uint32_t pad[3];
} plt_binary_ray;

_Static_assert(sizeof(plt_binary_ray) == sizeof(plt_wave_ray) + PLT_WAVE_BINARY_BYTES,
               "what plt_wave_stack_bytes counts with");

/* What min leaves of planes x y z for the left child, by three owner bits: those of the right
 * child become -infinity. Axes have these bits. */
#define PLT_BINARY_CUT(x, y, z)                                                                    \
    {                                                                                              \
        PLT_CUT(0, x, y, z), PLT_CUT(1, x, y, z), PLT_CUT(2, x, y, z), PLT_CUT(3, x, y, z),        \
            PLT_CUT(4, x, y, z), PLT_CUT(5, x, y, z), PLT_CUT(6, x, y, z), PLT_CUT(7, x, y, z)     \
    }
#define PLT_CUT(owners, x, y, z)                                                                   \
    { PLT_KEPT(owners, x), PLT_KEPT(owners, y), PLT_KEPT(owners, z), -PLT_ENDLESS }
#define PLT_KEPT(owners, bit) ((owners) & (bit) ? -PLT_ENDLESS : PLT_ENDLESS)

/* By plt_wave_found.row: how far above the top of the stack the left child goes, the nearest
 * last. The right one goes to the other place. And how many there are. */
static const uint8_t plt_binary_place[8] = {0, 0, 0, 0, 1, 0, 1, 1};
static const uint8_t plt_binary_ones[8] = {0, 1, 0, 1, 1, 2, 1, 2};

/* Where the ray is in both children, from where it is in their parent, planes of theirs and whose
 * they are. */
static inline f4 plt_binary_intervals(const plt_binary_ray *r, const float inside[2],
                                      const float cut[8][4], f4 lo, f4 hi, uint32_t mins,
                                      uint32_t maxs) {
    const f4 rdir = f4_load_16(r->rdir);
    const m4 negative = f4_lt(rdir, f4_zero());
    const f4 near = f4_mul(f4_sub(f4_select(negative, hi, lo), f4_load_16(r->near_org)), rdir);
    const f4 far = f4_mul(f4_sub(f4_load_16(r->far_org), f4_select(negative, lo, hi)), rdir);
    const uint32_t swapped = (mins ^ maxs) & r->negative;
    const uint32_t nears = mins ^ swapped, fars = maxs ^ swapped;
    f4 row[4] = {f4_min(near, f4_load(cut[nears])), f4_min(far, f4_load(cut[fars])),
                 f4_min(near, f4_load(cut[nears ^ 7u])), f4_min(far, f4_load(cut[fars ^ 7u]))};
    f4_transpose(&row[0], &row[1], &row[2], &row[3]);
    const f4 least = f4_max(f4_load_pair(inside), f4_load_16(r->range));
    return f4_max(f4_max(f4_max(row[0], row[1]), row[2]), least);
}

/* Which children are met (bits 0 and 2), and whether the left one is nearer (bit 1). */
static inline void plt_binary_find(f4 at, plt_wave_found *to) {
    const f4 next = f4_rotate(at);
    const unsigned met = m4_mask(f4_le(at, f4_neg(next)));
    const unsigned order = m4_mask(f4_lt(at, f4_rotate(next)));
    f4_store(to->at, at);
    to->row = (met & 5u) | (order & 1u) << 1;
}

static inline void plt_binary_set(plt_binary_ray *r, const uint8_t axis_bit[3]) {
    r->negative = 0;
    for (int a = 0; a < 3; a++) {
        r->near_org[a] = r->ray.near_org[a][0];
        r->far_org[a] = r->ray.far_org[a][0];
        r->rdir[a] = r->ray.rdir[a][0];
        r->negative |= (r->rdir[a] < 0.0f ? axis_bit[a] : 0u);
    }
    r->near_org[3] = r->far_org[3] = r->rdir[3] = 1.0f;
    r->range[0] = r->range[2] = r->ray.tmin[0];
    r->range[1] = r->range[3] = -r->ray.tmax[0];
}

/* Behind a new hit there is nothing left to find. */
static inline void plt_binary_end(plt_binary_ray *r) {
    r->range[1] = r->range[3] = -r->ray.tmax[0];
}

/* Where the ray is in the scene's box. */
static inline void plt_binary_root(const plt_binary_ray *r, const plt_box *box, float inside[2]) {
    inside[0] = inside[1] = -PLT_ENDLESS;
    for (int a = 0; a < 3; a++) {
        const int negative = r->rdir[a] < 0.0f;
        const float n = ((negative ? box->hi[a] : box->lo[a]) - r->near_org[a]) * r->rdir[a];
        const float f = (r->far_org[a] - (negative ? box->lo[a] : box->hi[a])) * r->rdir[a];
        inside[0] = n > inside[0] ? n : inside[0];
        inside[1] = f > inside[1] ? f : inside[1];
    }
}

#endif
