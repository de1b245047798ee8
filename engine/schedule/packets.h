/* packets - many packets in one piece of memory
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCHEDULE_PACKETS_H
#define PLT_SCHEDULE_PACKETS_H

#include "engine/trace/packet.h"

/* What `packets` packets take without their rays, a multiple of 16. */
static inline uint64_t plt_packets_heads_bytes(uint32_t packets) {
    return ((uint64_t)packets * sizeof(plt_packet) + 15) & ~(uint64_t)15;
}

/* Bytes of `packets` packets of side^2 rays, a multiple of 16. */
static inline uint64_t plt_packets_bytes(uint32_t packets, unsigned side) {
    return plt_packets_heads_bytes(packets) + (uint64_t)packets * plt_packet_bytes(side);
}

/* Tasks that there is room for: 64 per packet, which unrelated rays have seldom more of (fewer for
 * those so small that tasks would take more than rays), and a few. */
static inline uint32_t plt_packets_tasks(uint32_t packets, unsigned side) {
    return (side < 8 ? 8 * side : 64) * packets + 64;
}

/* Lays them out in `memory`, plt_packets_bytes of it; their slabs, rays and hulls lie behind
 * them. */
static inline plt_packet *plt_packets_init(uint32_t packets, unsigned side, void *memory) {
    plt_packet *packet = (plt_packet *)memory;
    unsigned char *rays = (unsigned char *)memory + plt_packets_heads_bytes(packets);
    for (uint32_t i = 0; i < packets; i++) {
        plt_packet_init(&packet[i], rays + i * plt_packet_bytes(side), side);
    }
    return packet;
}

#endif
