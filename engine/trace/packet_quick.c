/* packet_quick - see packet_quick.h
 *
 * SPDX-License-Identifier: MIT */
#define PLT_ASKS_FLUSHED 1
#include "engine/trace/packet_quick.h"

#include "engine/trace/packet_group.h"
#include "engine/trace/unless_flushed.h"

#if PLT_QUICK_LANES

int plt_packet_set_quickly(plt_packet *p, unsigned index, unsigned count, int *has_rays) {
    const plt_group_slabs *s = &p->slabs.group[index];
    const plt_group_rays *g = &p->rays[index];
    const f4 org[3] = {f4_load(g->org[0]), f4_load(g->org[1]), f4_load(g->org[2])};
    const f4 dir[3] = {f4_load(g->dir[0]), f4_load(g->dir[1]), f4_load(g->dir[2])};
    *has_rays = set_group(p, index, org, dir, f4_load(s->tmin), f4_load(s->tmax), count);
    return !plt_was_flushed(has_rays);
}

/* Scalar lanes, which set groups up where these flushed, may have left a flag that says nothing
 * of what is compared. */
void plt_packet_compare_quickly(const plt_packet *p, plt_common *c) {
    plt_flushed_clear();
    compare_groups(p, c);
    if (plt_was_flushed(c)) {
        *c = (plt_common){15, 7, {15, 15, 15}, {0.0f, 0.0f, 0.0f}};
    }
}

#endif
