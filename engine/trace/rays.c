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
