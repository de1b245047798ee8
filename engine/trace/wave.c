/* wave - see wave.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/wave.h"

#include "engine/trace/coherence.h"
#include "engine/trace/wave_bvh4.h"
#include "engine/trace/wave_compact.h"
#include "engine/trace/wave_thesis.h"

int plt_wave_trace(plt_traversal *t, plt_packet *packet, uint32_t most, int looks,
                   const plt_ray *rays, plt_hit *hits, uint32_t count, int any) {
    const uint32_t window = most > PLT_COHERENCE_WINDOW ? most : PLT_COHERENCE_WINDOW;
    plt_wave_job job = {.wave = t->wave,
                        .traversal = t,
                        .packet = packet,
                        .packet_rays = most,
                        .window = looks ? window : 0,
                        .rays = rays,
                        .hits = hits,
                        .count = count,
                        .any = any};
    if (t->scene->bvh4 != NULL) {
        plt_wave_bvh4(&job);
    } else if (t->scene->format == PLT_FORMAT_COMPACT) {
        PLT_IF(PLT_WITH_WAVE_COMPACT, plt_wave_compact(&job);)
    } else {
        PLT_IF(PLT_WITH_THESIS, plt_wave_thesis(&job);)
    }
    return job.status;
}
