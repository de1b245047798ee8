/* mask - a set of groups of a packet, a bit each
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_MASK_H
#define PLT_TRACE_MASK_H

#include <stdint.h>

#include "engine/planelet_config.h"

#define PLT_GROUPS_MAX (PLT_PACKET_SIDE_MAX * PLT_PACKET_SIDE_MAX / 4)

#if PLT_GROUPS_MAX > 32
typedef uint64_t plt_mask;
#else
typedef uint32_t plt_mask;
#endif

/* Number of the lowest group; the mask is not empty. */
static inline unsigned plt_mask_first(plt_mask m) {
#if PLT_GROUPS_MAX > 32
    return (unsigned)__builtin_ctzll(m);
#else
    return (unsigned)__builtin_ctz(m);
#endif
}

/* Number of the highest. */
static inline unsigned plt_mask_last(plt_mask m) {
#if PLT_GROUPS_MAX > 32
    return 63u - (unsigned)__builtin_clzll(m);
#else
    return 31u - (unsigned)__builtin_clz(m);
#endif
}

/* How many groups, by adding up ever wider fields. */
static inline uint32_t plt_mask_count(plt_mask m) {
    const plt_mask all = (plt_mask) ~(plt_mask)0;
    m -= m >> 1 & all / 3;
    m = (m & all / 15 * 3) + (m >> 2 & all / 15 * 3);
    m = (m + (m >> 4)) & all / 255 * 15;
    return (uint32_t)((plt_mask)(m * (all / 255)) >> (8 * sizeof m - 8));
}

static inline plt_mask plt_mask_of(unsigned group, unsigned on) {
    return (plt_mask)on << group;
}

#endif
