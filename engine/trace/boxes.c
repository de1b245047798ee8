/* boxes - see boxes.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/boxes.h"

enum way { SHARED, EQUAL, MIXED };

/* One box as each way wants it, spread over four lanes. */
typedef struct planes {
    f4 near[3], far[3]; /* SHARED: less the origin; MIXED: lo and hi */
} planes;

static inline void spread(planes *b, const plt_packet *p, const float *lo, const float *hi,
                          enum way way) {
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const int swap = way != MIXED && p->negative[a];
        const float near = swap ? hi[a] : lo[a];
        const float far = swap ? lo[a] : hi[a];
        b->near[a] = f4_all(way == SHARED ? near - p->near_org[a] : near);
        b->far[a] = f4_all(way == SHARED ? far - p->far_org[a] : far);
    }
}

static inline void distances(const planes *b, const plt_group *g, int a, enum way way, f4 *near,
                             f4 *far) {
    const f4 rdir = f4_load(g->rdir[a]);
    f4 n = b->near[a], f = b->far[a];
    if (way == MIXED) {
        const m4 negative = f4_lt(rdir, f4_zero());
        n = f4_select(negative, b->far[a], b->near[a]);
        f = f4_select(negative, b->near[a], b->far[a]);
    }
    if (way != SHARED) {
        n = f4_sub(n, f4_load(g->near_org[a]));
        f = f4_sub(f, f4_load(g->far_org[a]));
    }
    *near = f4_mul(n, rdir);
    *far = f4_mul(f, rdir);
}

static inline m4 meets(const planes *b, const plt_group *g, enum way way, f4 *entry) {
    f4 n[3], f[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        distances(b, g, a, way, &n[a], &f[a]);
    }
    *entry = f4_max(f4_max(n[0], n[1]), f4_max(n[2], f4_load(g->tmin)));
    const f4 leave = f4_min(f4_min(f[0], f[1]), f4_min(f[2], f4_load(g->tmax)));
    return f4_le(*entry, leave);
}

static inline plt_mask groups_in(const plt_packet *p, const float *lo, const float *hi,
                                 plt_mask groups, enum way way) {
    planes b;
    plt_mask hit = 0;
    spread(&b, p, lo, hi, way);
    for (plt_mask m = groups; m != 0; m &= m - 1) {
        f4 entry;
        const unsigned i = plt_mask_first(m);
        hit |= plt_mask_of(i, m4_mask(meets(&b, &p->group[i], way, &entry)) != 0);
    }
    return hit;
}

static inline void groups_in_both(const plt_packet *p, const float *const lo[2],
                                  const float *const hi[2], plt_mask groups, plt_mask hit[2],
                                  enum way way) {
    planes b[2];
    plt_mask left = 0, right = 0;
    spread(&b[0], p, lo[0], hi[0], way);
    spread(&b[1], p, lo[1], hi[1], way);
    for (plt_mask m = groups; m != 0; m &= m - 1) {
        f4 entry;
        const unsigned i = plt_mask_first(m);
        left |= plt_mask_of(i, m4_mask(meets(&b[0], &p->group[i], way, &entry)) != 0);
        right |= plt_mask_of(i, m4_mask(meets(&b[1], &p->group[i], way, &entry)) != 0);
    }
    hit[0] = left;
    hit[1] = right;
}

plt_mask plt_box_groups(const plt_packet *p, const float *lo, const float *hi, plt_mask groups) {
    if (p->shared) {
        return groups_in(p, lo, hi, groups, SHARED);
    }
    return p->mixed ? groups_in(p, lo, hi, groups, MIXED) : groups_in(p, lo, hi, groups, EQUAL);
}

void plt_box_pair(const plt_packet *p, const float *const lo[2], const float *const hi[2],
                  plt_mask groups, plt_mask hit[2]) {
    if (p->shared) {
        groups_in_both(p, lo, hi, groups, hit, SHARED);
    } else if (p->mixed) {
        groups_in_both(p, lo, hi, groups, hit, MIXED);
    } else {
        groups_in_both(p, lo, hi, groups, hit, EQUAL);
    }
}

float plt_box_entry(const plt_packet *p, const plt_box *box, plt_mask groups) {
    planes b;
    f4 entry;
    spread(&b, p, box->lo, box->hi, MIXED); /* right for any packet, and rare */
    const m4 hit = meets(&b, &p->group[plt_mask_first(groups)], MIXED, &entry);
    return f4_min_lane(f4_select(hit, entry, f4_all(PLT_BOX_FAR)));
}
