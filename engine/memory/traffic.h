/* traffic - what a traversal would fetch if the scene were streamed
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MEMORY_TRAFFIC_H
#define PLT_MEMORY_TRAFFIC_H

#include "engine/planelet.h"

/* `bytes` are touched. `slot`: their bit in `touched`, which is set the first time; NULL: not
 * asked for. */
static inline void plt_traffic_touch(plt_stats *stats, uint32_t *touched, uint32_t slot,
                                     uint32_t bytes) {
    if (touched != NULL && !(touched[slot / 32] >> slot % 32 & 1u)) {
        touched[slot / 32] |= 1u << slot % 32;
        stats->bytes_touched_once += bytes;
    }
}

/* The same of bytes that were not at hand. */
static inline void plt_traffic_count(plt_stats *stats, uint32_t *touched, uint32_t slot,
                                     uint32_t bytes) {
    stats->bytes_fetched += bytes;
    plt_traffic_touch(stats, touched, slot, bytes);
}

#endif
