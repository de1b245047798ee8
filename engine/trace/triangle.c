/* triangle - see triangle.h
 *
 * Error bounds: triangle_common.h.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/triangle.h"

#include "engine/base/small_stack.h"

#if !PLT_WITH_HULLS

#include "engine/trace/triangle_cull.h"
#include "engine/trace/triangle_plain.h"
#include "engine/trace/triangle_record.h"

/* Where the rays are inside the triangle's own box, as boxes.c would say. */
PLT_APART_ON_SMALL_STACKS static m4 own_box(const prepared *t, const plt_group_slabs *s, f4 *enter,
                                            f4 *leave) {
    f4 n[3], f[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 p = f4_all(t->triangle->corner[0][a]), q = f4_all(t->triangle->corner[1][a]),
                 r = f4_all(t->triangle->corner[2][a]);
        const f4 lo = f4_min(f4_min(p, q), r), hi = f4_max(f4_max(p, q), r);
        const f4 rdir = f4_load(s->rdir[a]);
        const m4 negative = f4_lt(rdir, f4_zero());
        n[a] = f4_mul(f4_sub(f4_select(negative, hi, lo), f4_load(s->near_org[a])), rdir);
        f[a] = f4_mul(f4_sub(f4_select(negative, lo, hi), f4_load(s->far_org[a])), rdir);
    }
    *enter = f4_max(f4_max(n[0], n[1]), n[2]);
    *leave = f4_min(f4_min(f[0], f[1]), f[2]);
    return f4_le(*enter, *leave);
}

static unsigned record_hits(const prepared *t, plt_packet *p, unsigned index, edges *e, int z,
                            unsigned lanes) {
    const plt_triangle *triangle = t->triangle;
    passing at;
    at.corner = triangle->corner;
    at.longest = triangle->longest;
    at.word = triangle->word;
    at.ids = triangle->ids;
    plt_triangle_normal(triangle->corner, at.normal);
    at.numerator = plane_numerator(triangle->corner[0], at.normal, &p->rays[index]);
    at.in_box = own_box(t, &p->slabs.group[index], &at.enter, &at.leave);
    return record_passing(&at, p, index, e, z, lanes);
}

static inline unsigned test_axis(const prepared *t, plt_packet *p, unsigned index, int z,
                                 enum sharing sharing) {
    const plt_group_rays *g = &p->rays[index];
    edges e = edges_of(t, g, z, sharing);
    const unsigned may = may_cover(t, g, &e, sharing) & g->axis_lanes[z];
    if (may == 0) {
        return 0;
    }
    edges kept = e; /* so that e stays in registers for a miss, the common case */
    return record_hits(t, p, index, PLT_LANES_REGISTERS ? &kept : &e, z, may);
}

static inline void test_group(const prepared *t, plt_packet *p, unsigned index,
                              enum sharing sharing) {
    unsigned hits = 0;
    if (sharing == PER_PACKET || p->axis != PLT_AXES_DIFFER) {
        hits = test_axis(t, p, index, p->axis, sharing);
    } else {
        for (int z = 0; z < 3; z++) {
            hits |= p->rays[index].axis_lanes[z] != 0 ? test_axis(t, p, index, z, sharing) : 0;
        }
    }
    if (p->any && hits != 0) {
        retire_group(p, index);
    }
}

static inline void test_groups(prepared *t, plt_packet *p, plt_mask groups, enum sharing sharing) {
    prepare(t, p, sharing);
    for (plt_mask m = groups; m != 0; m &= m - 1) {
        test_group(t, p, plt_mask_first(m), sharing);
    }
}

void plt_triangle_groups(plt_packet *p, const plt_triangle *triangle, plt_mask groups) {
    prepared t;
    t.triangle = triangle;
#if PLT_LANES_FLUSHES
    groups = plt_triangle_may_meet(p, triangle, groups);
    if (groups == 0) {
        return;
    }
#endif
    if (p->slabs.coherence == PLT_ONE_ORIGIN && p->axis != PLT_AXES_DIFFER) {
        test_groups(&t, p, groups, PER_PACKET);
    } else {
        test_groups(&t, p, groups, PER_GROUP);
    }
}

#endif
