/* packet_mask - a set of a packet's rays, a bit each
 *
 * Ray i is lane i & 3 of group i >> 2. Two sets are kept (thesis, section 3.5.2): all rays that are
 * active, or the groups from the first to the last that have one, which is a convex part of the
 * packet as rays are in the order of a scan.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_PACKET_MASK_H
#define BASELINES_PACKET_MASK_H

#include <stdint.h>

#include "engine/trace/mask.h"

enum { PACKET_RAYS = PLT_PACKET_SIDE_MAX * PLT_PACKET_SIDE_MAX, PACKET_GROUPS = PLT_GROUPS_MAX };

/* 16 groups to a word. */
enum { PACKET_WORDS = (PACKET_GROUPS + 15) / 16 };

typedef struct packet_mask {
    uint64_t word[PACKET_WORDS];
} packet_mask;

/* Groups first .. last; none: first > last. */
typedef struct packet_range {
    uint8_t first, last;
} packet_range;

static inline void packet_mask_clear(packet_mask *m) {
    for (int w = 0; w < PACKET_WORDS; w++) {
        m->word[w] = 0;
    }
}

static inline unsigned packet_mask_lanes(const packet_mask *m, unsigned group) {
    return (unsigned)(m->word[group / 16] >> 4 * (group % 16)) & 15u;
}

/* Those that are in it stay. */
static inline void packet_mask_add(packet_mask *m, unsigned group, unsigned lanes) {
    m->word[group / 16] |= (uint64_t)lanes << 4 * (group % 16);
}

/* The lowest group with a ray in it from `group` on, or PACKET_GROUPS. */
static inline unsigned packet_mask_next(const packet_mask *m, unsigned group) {
    for (unsigned w = group / 16; w < PACKET_WORDS; w++) {
        const uint64_t left =
            w == group / 16 ? m->word[w] >> 4 * (group % 16) << 4 * (group % 16) : m->word[w];
        if (left != 0) {
            return 16 * w + (unsigned)__builtin_ctzll(left) / 4;
        }
    }
    return PACKET_GROUPS;
}

static inline unsigned packet_mask_count(const packet_mask *m) {
    unsigned count = 0;
    for (int w = 0; w < PACKET_WORDS; w++) {
        count += (unsigned)__builtin_popcountll(m->word[w]);
    }
    return count;
}

/* Groups with a ray in it. */
static inline plt_mask packet_mask_groups(const packet_mask *m) {
    plt_mask groups = 0;
    for (unsigned g = packet_mask_next(m, 0); g < PACKET_GROUPS; g = packet_mask_next(m, g + 1)) {
        groups |= plt_mask_of(g, 1);
    }
    return groups;
}

static inline plt_mask packet_range_groups(const packet_range *r) {
    const plt_mask upto = ((plt_mask)2 << r->last) - 1;
    return r->first > r->last ? 0 : upto & ~(((plt_mask)1 << r->first) - 1);
}

#endif
