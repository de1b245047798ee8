/* boxes - see boxes.h
 *
 * SPDX-License-Identifier: MIT */
#define PLT_ASKS_FLUSHED 1
#include "engine/trace/boxes.h"

#include "engine/trace/planes.h"
#include "engine/trace/unless_flushed.h"

/* With vectors of few instructions each kind has code of its own. */
#if PLT_LANES_FLUSHES
#define PER_KIND PLT_INLINED
#else
#define PER_KIND static inline
#endif

PER_KIND void set_planes(plt_planes *b, const plt_slab_array *slabs, const plt_box *box,
                         enum plt_coherence kind) {
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const int swap = kind != PLT_MIXED && slabs->negative[a];
        const float near = swap ? box->hi[a] : box->lo[a];
        const float far = swap ? box->lo[a] : box->hi[a];
        b->near[a] = f4_all(kind == PLT_ONE_ORIGIN ? near - slabs->near_org[a] : near);
        b->far[a] = f4_all(kind == PLT_ONE_ORIGIN ? far - slabs->far_org[a] : far);
    }
}

PER_KIND m4 meets(const plt_planes *b, const plt_group_slabs *g, enum plt_coherence kind,
                  f4 *entry) {
    f4 n[3], f[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 rdir = f4_load(g->rdir[a]);
        plt_plane_depths(b, a, g, rdir, rdir, kind, &n[a], &f[a]);
    }
    *entry = f4_max(f4_max(n[0], n[1]), f4_max(n[2], f4_load(g->tmin)));
    const f4 leave = f4_min(f4_min(f[0], f[1]), f4_min(f[2], f4_load(g->tmax)));
    return f4_le(*entry, leave);
}

PER_KIND plt_mask test_box(const plt_slab_array *slabs, const plt_box *box, plt_mask groups,
                           enum plt_coherence kind) {
    plt_planes b;
    plt_mask hit = 0;
    set_planes(&b, slabs, box, kind);
    for (plt_mask m = groups; m != 0; m &= m - 1) {
        f4 entry;
        const unsigned i = plt_mask_first(m);
        hit |= plt_mask_of(i, m4_mask(meets(&b, &slabs->group[i], kind, &entry)) != 0);
    }
    return plt_unless_flushed(&hit, groups);
}

/* Planes at an address that the compiler does not know, and one box after the other: else gcc 12
 * mixes the tests of both, for which MVE has too few registers (125 instructions per group). */
static inline const plt_planes *as_loaded(const plt_planes *b) {
#if PLT_LANES_FLUSHES && defined(__GNUC__)
    __asm__ volatile("" : "+r"(b) : : "memory");
#endif
    return b;
}

PER_KIND uint32_t test_pair(const plt_slab_array *slabs, const plt_box child[2], plt_mask groups,
                            plt_mask hit[2], enum plt_coherence kind) {
    plt_planes b[2];
    plt_mask left = 0, right = 0;
    uint32_t tested = 0;
    set_planes(&b[0], slabs, &child[0], kind);
    set_planes(&b[1], slabs, &child[1], kind);
    for (plt_mask m = groups; m != 0; m &= m - 1, tested++) {
        f4 entry;
        const unsigned i = plt_mask_first(m);
        const plt_planes *at = as_loaded(b);
        left |= plt_mask_of(i, m4_mask(meets(&at[0], &slabs->group[i], kind, &entry)) != 0);
        at = as_loaded(at + 1);
        right |= plt_mask_of(i, m4_mask(meets(at, &slabs->group[i], kind, &entry)) != 0);
    }
    hit[0] = left;
    hit[1] = right;
    if (plt_was_flushed(hit)) {
        hit[0] = hit[1] = groups;
    }
    return tested;
}

plt_mask plt_box_groups(const plt_slab_array *slabs, const plt_box *box, plt_mask groups) {
    switch (slabs->coherence) {
    case PLT_ONE_ORIGIN:
        return test_box(slabs, box, groups, PLT_ONE_ORIGIN);
    case PLT_ONE_SIGN:
        return test_box(slabs, box, groups, PLT_ONE_SIGN);
    default:
        return test_box(slabs, box, groups, PLT_MIXED);
    }
}

uint32_t plt_box_pair(const plt_slab_array *slabs, const plt_box child[2], plt_mask groups,
                      plt_mask hit[2]) {
    switch (slabs->coherence) {
    case PLT_ONE_ORIGIN:
        return test_pair(slabs, child, groups, hit, PLT_ONE_ORIGIN);
    case PLT_ONE_SIGN:
        return test_pair(slabs, child, groups, hit, PLT_ONE_SIGN);
    default:
        return test_pair(slabs, child, groups, hit, PLT_MIXED);
    }
}

float plt_box_entry(const plt_slab_array *slabs, const plt_box *box, plt_mask groups) {
    plt_planes b;
    f4 entry;
    set_planes(&b, slabs, box, PLT_MIXED); /* right for any packet; calls are rare */
    const m4 hit = meets(&b, &slabs->group[plt_mask_first(groups)], PLT_MIXED, &entry);
    return f4_min_lane(f4_select(hit, entry, f4_all(PLT_NOT_ENTERED)));
}
