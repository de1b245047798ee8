/* ray_packets - an array of rays, packet after packet
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_RAY_PACKETS_H
#define PLT_TRACE_RAY_PACKETS_H

#include "engine/trace/rays.h"

/* Traces any number of rays, in packets of `most`, which are those of `packet`. PLT_OK, or what
 * a fetch failed with: then hits from that packet on are as they were. Inline, as all packets lie
 * on top of its stack. */
static inline int plt_trace_packets(plt_traversal *t, plt_packet *packet, uint32_t most,
                                    const plt_ray *rays, plt_hit *hits, uint32_t count, int any) {
    int status = PLT_OK;
    while (count > 0 && status == PLT_OK) {
        const uint32_t now = count < most ? count : most;
        status = plt_trace_packet(t, packet, rays, hits, now, any);
        rays += now;
        hits += now;
        count -= now;
    }
    return status;
}

#endif
