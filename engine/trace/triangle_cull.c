/* triangle_cull - see triangle_cull.h
 *
 * The arithmetic of triangle.c up to where it turns a group away.
 *
 * SPDX-License-Identifier: MIT */
#define PLT_ASKS_FLUSHED 1
#include "engine/trace/triangle_cull.h"

#include "engine/trace/triangle_plain.h"
#include "engine/trace/unless_flushed.h"

#if PLT_LANES_FLUSHES && !PLT_WITH_HULLS

PLT_INLINED unsigned covers(const prepared *t, const plt_group_rays *g, int z,
                            enum sharing sharing) {
    const edges e = edges_of(t, g, z, sharing);
    return may_cover(t, g, &e, sharing) & g->axis_lanes[z];
}

PLT_INLINED plt_mask cull(prepared *t, const plt_packet *p, plt_mask groups, enum sharing sharing) {
    plt_mask may = 0;
    prepare(t, p, sharing);
#ifdef __GNUC__
    __asm__("" : "+r"(t) : : "memory"); /* as in boxes.c */
#endif
    for (plt_mask m = groups; m != 0; m &= m - 1) {
        const unsigned i = plt_mask_first(m);
        may |= plt_mask_of(i, covers(t, &p->rays[i], p->axis, sharing) != 0);
    }
    return may;
}

plt_mask plt_triangle_may_meet(const plt_packet *p, const plt_triangle *triangle, plt_mask groups) {
    prepared t;
    t.triangle = triangle;
    if (p->axis == PLT_AXES_DIFFER) {
        return groups;
    }
    plt_mask may = p->slabs.coherence == PLT_ONE_ORIGIN ? cull(&t, p, groups, PER_PACKET)
                                                        : cull(&t, p, groups, PER_GROUP);
    return plt_unless_flushed(&may, groups);
}

#endif
