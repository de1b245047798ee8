/* rays - see rays.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/rays.h"

int plt_trace_packet(plt_traversal *t, plt_packet *p, const plt_ray *rays, plt_hit *hits,
                     uint32_t count, int any) {
    int status = PLT_MORE;
    plt_packet_set_rays(p, &t->scene->box, rays, count, any);
    plt_traversal_begin(t, p, count);
    while (status == PLT_MORE) {
        status = plt_traverse(t, p, 0xFFFFFFFFu);
    }
    if (status == PLT_OK) {
        plt_packet_store(p, hits, count);
    }
    return status;
}

int plt_trace_packets(plt_traversal *t, plt_packet *p, uint32_t most, const plt_ray *rays,
                      plt_hit *hits, uint32_t count, int any) {
    int status = PLT_OK;
    while (count > 0 && status == PLT_OK) {
        const uint32_t now = count < most ? count : most;
        status = plt_trace_packet(t, p, rays, hits, now, any);
        rays += now;
        hits += now;
        count -= now;
    }
    return status;
}
