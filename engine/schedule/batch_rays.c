/* batch_rays - see batch_rays.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/schedule/batch_rays.h"

#include "engine/base/small_stack.h"
#include "engine/trace/packet_rays.h"

static uint32_t least(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

/* As many as there is room for; how many rays they are. */
PLT_APART_ON_SMALL_STACKS static uint32_t add_packets(plt_batch *b, plt_traversal *t, uint32_t most,
                                                      const plt_ray *rays, uint32_t count,
                                                      int any) {
    uint32_t taken = 0;
    plt_batch_clear(b);
    while (b->count < b->most && taken < count) {
        const uint32_t now = least(most, count - taken);
        plt_packet_set_rays(&b->packet[b->count], &t->scene->box, rays + taken, now, any);
        plt_batch_add(b, t, now);
        taken += now;
    }
    return taken;
}

PLT_APART_ON_SMALL_STACKS static void store_packets(const plt_batch *b, uint32_t most,
                                                    plt_hit *hits, uint32_t count) {
    for (uint32_t i = 0; i < b->count; i++) {
        const uint32_t at = i * most;
        plt_packet_store(&b->packet[i], hits + at, least(most, count - at));
    }
}

int plt_batch_trace_rays(plt_batch *b, plt_traversal *t, uint32_t most, const plt_ray *rays,
                         plt_hit *hits, uint32_t count, int any) {
    while (count > 0) {
        const uint32_t now = add_packets(b, t, most, rays, count, any);
        int status = PLT_MORE;
        while (status == PLT_MORE) {
            status = plt_batch_trace(b, t, 0xFFFFFFFFu);
        }
        if (status != PLT_OK) {
            return status;
        }
        store_packets(b, most, hits, now);
        rays += now;
        hits += now;
        count -= now;
    }
    return PLT_OK;
}
