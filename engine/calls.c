/* calls - the public calls on an engine that is open
 *
 * SPDX-License-Identifier: MIT */
#include "engine/engine.h"

#include "engine/base/fault.h"
#include "engine/move.h"
#include "engine/schedule/batch_rays.h"
#include "engine/task.h"
#include "engine/texture_room.h"
#include "engine/trace/ray_packets.h"
#include "engine/trace/wave.h"

const plt_info *plt_engine_info(const plt_engine *e) {
    return &e->scene.info;
}

#if PLT_WITH_GROUPS
int plt_trace(plt_engine *e, const plt_ray *rays, plt_hit *hits, uint32_t count, int any) {
    const uint32_t most = (uint32_t)e->options.packet_side * e->options.packet_side;
    e->rendering.done = 1;
    plt_texture_forget(e);
#if PLT_WITH_TASK
    if (e->is_worker) {
        return plt_task_trace(e, rays, hits, count, any);
    }
#endif
#if PLT_WITH_BATCH
    if (e->batch.most > 0) {
        return plt_batch_trace_rays(&e->batch, &e->traversal, most, rays, hits, count, any);
    }
#endif
#if PLT_WITH_WAVE
    if (e->traversal.wave != NULL && e->options.rays != PLT_RAYS_COHERENT) {
        const int looks = e->options.rays == PLT_RAYS_AUTO;
        return plt_wave_trace(&e->traversal, &e->packet, most, looks, rays, hits, count, any);
    }
#endif
    return plt_trace_packets(&e->traversal, &e->packet, most, rays, hits, count, any);
}

#else
int plt_trace(plt_engine *e, const plt_ray *rays, plt_hit *hits, uint32_t count, int any) {
    (void)rays;
    (void)hits;
    (void)count;
    (void)any;
    e->rendering.done = 1;
    return PLT_ERR_LIMIT;
}
#endif

int plt_render_begin(plt_engine *e, const plt_frame *frame) {
    plt_texture_forget(e);
#if PLT_WITH_TASK
    if (e->is_worker && e->dispatch.most == 0) {
        return PLT_ERR_ARGUMENT;
    }
    plt_task_drop(e);
#endif
    return plt_rendering_begin(&e->rendering, frame, &e->traversal);
}

int plt_render_step(plt_engine *e, uint32_t visits) {
#if PLT_WITH_TASK
    if (e->is_worker) {
        return e->rendering.done ? PLT_OK : plt_task_step(e, visits);
    }
#endif
    return plt_rendering_step(&e->rendering, &e->traversal, &e->packet, visits);
}

void plt_render_tile(const plt_engine *e, plt_tile *tile) {
    plt_rendering_tile(&e->rendering, tile);
}

void plt_fault_get(const plt_engine *e, plt_fault *fault) {
    if (plt_texture_failed(e, fault)) {
        return;
    }
#if PLT_WITH_STREAMED
    if (plt_is_streamed(e->scene.format)) {
        const void *state = e->traversal.state;
        *fault = e->scene.format == PLT_FORMAT_STREAMED
                     ? ((const plt_stream *)state)->fetcher.fault
                     : ((const plt_treelet_stream *)state)->fetcher.fault;
        return;
    }
#endif
    (void)e;
    plt_fault_set(fault, PLT_OK, 0, "no fault");
}

void plt_stats_get(const plt_engine *e, plt_stats *stats) {
    *stats = e->traversal.stats;
}

void plt_stats_reset(plt_engine *e) {
#if PLT_WITH_REBUILD
    plt_rebuild_before_reset(e);
#endif
    plt_traversal_reset_stats(&e->traversal);
    plt_texture_stats_reset(e);
#if PLT_WITH_TASK
    const plt_task_stats none = {0};
    e->dispatch.stats = none;
#endif
}

unsigned plt_packet_side(const plt_engine *e) {
    return e->options.packet_side;
}

#if PLT_WITH_BATCH
unsigned plt_batch_packets(const plt_engine *e) {
#if PLT_WITH_TASK
    return e->dispatch.rooms > 0 ? e->dispatch.rooms : e->batch.most;
#else
    return e->batch.most;
#endif
}
#endif

size_t plt_arena_used(const plt_engine *e) {
    return e->arena.used;
}

size_t plt_arena_peak(const plt_engine *e) {
    return e->arena.peak;
}
