/* visits - how many nodes packets may visit, in any tree that opens
 *
 * In one packet a group of four rays visits a node once. Without hulls all groups of a packet
 * visit it together; hulls may send each there by itself.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_VISITS_H
#define REFERENCE_VISITS_H

#include "engine/planelet.h"
#include "engine/planelet_config.h"

static inline uint64_t visits_most(const plt_stats *s, uint64_t nodes) {
    return (PLT_WITH_HULLS ? s->rays / 4 + s->packets : s->packets) * nodes;
}

#endif
