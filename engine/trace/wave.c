/* wave - see wave.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/wave.h"

#include "engine/trace/wave_bvh4.h"

void plt_wave_trace(plt_traversal *t, plt_packet *staging, const plt_ray *rays, plt_hit *hits,
                    uint32_t count, int any) {
    plt_wave_job job = {t->wave, &t->scene->box, staging, rays, hits, count, 0, any};
    plt_packet_begin(staging, 1, any);
    t->stats.rays += count;
    t->stats.wave_rays += count;
    plt_wave_bvh4(t, &job);
}
