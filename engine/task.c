/* task - see task.h, and the public calls that workers make
 *
 * The dispatcher's packets are of its frame or of the rays that it was given. Who traces a packet
 * first sets it up, and who traces it last shades it or stores its hits, so that next to nothing
 * is left to do one at a time.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/task.h"

#include <string.h>

#include "engine/shade/frame_packets.h"
#include "engine/trace/packet_rays.h"

static int is_of_rays(const plt_engine *d) {
    return d->shared.hits != NULL;
}

/* Rays of the packet that begins with ray `first`. */
static uint32_t rays_from(const plt_engine *d, uint32_t first) {
    const uint32_t most = (uint32_t)d->options.packet_side * d->options.packet_side;
    return d->shared.count - first < most ? d->shared.count - first : most;
}

static uint8_t *colours_of(const plt_engine *d, uint32_t slot) {
    const uint32_t side = d->options.packet_side;
    return d->colours + 3 * side * side * slot;
}

/* ---- a worker's part ---------------------------------------------------------------- */

static void set_up(const plt_engine *d, plt_engine *w) {
    const uint32_t *item = w->worker.item;
    plt_packet *p = w->worker.packet;
    uint32_t rays;
    if (is_of_rays(d)) {
        rays = rays_from(d, item[0]);
        plt_packet_set_rays(p, &d->scene.box, d->shared.rays + item[0], rays, d->shared.any);
    } else {
        rays = plt_frame_packet(&d->rendering, &d->scene.box, item, p);
    }
    plt_worker_begin(&w->worker, &w->traversal, rays);
}

/* Nothing waits: neither what the worker has found, nor what waited before. */
static int is_last(const plt_worker *w) {
    return w->packet->active == 0 || (w->edges.first == PLT_TASK_NONE && !w->has_others);
}

static void keep_result(const plt_engine *d, const plt_worker *w) {
    const uint32_t *item = w->item;
    const plt_packet *p = w->packet;
    if (is_of_rays(d)) {
        plt_packet_store(p, d->shared.hits + item[0], rays_from(d, item[0]));
    } else {
        plt_frame_shade(&d->rendering, item, p, colours_of(d, w->slot));
    }
}

int plt_task_run(const plt_engine *d, plt_engine *w, uint32_t visits) {
    plt_worker *worker = &w->worker;
    if (!w->is_worker || !worker->has || worker->is_done) {
        return PLT_OK;
    }
    if (worker->is_new) {
        set_up(d, w);
    }
    const int status = plt_worker_run(worker, &w->traversal, visits);
    if (status == PLT_OK && worker->status == PLT_OK && is_last(worker)) {
        keep_result(d, worker);
    }
    return status;
}

/* ---- the dispatcher's part -------------------------------------------------------------- */

void plt_task_drop(plt_engine *e) {
    if (e->dispatch.most > 0) {
        plt_dispatch_clear(&e->dispatch);
        plt_worker_clear(&e->worker);
    }
    memset(&e->shared, 0, sizeof e->shared);
}

/* The next packet that is not in the ring yet. 0: there is none. */
static int next_item(plt_engine *d, uint32_t item[2]) {
    if (!is_of_rays(d)) {
        return plt_frame_next(&d->rendering, item);
    }
    item[0] = d->shared.next;
    item[1] = 0;
    d->shared.next += d->shared.next < d->shared.count ? rays_from(d, d->shared.next) : 0;
    return d->shared.next > item[0];
}

static void add_packets(plt_engine *d) {
    uint32_t item[2];
    if (d->dispatch.count == 0 && !is_of_rays(d)) {
        plt_frame_go_on(&d->rendering);
    }
    while (d->dispatch.count < d->dispatch.most && next_item(d, item)) {
        plt_dispatch_add(&d->dispatch, item);
    }
}

/* Takes packets that are done out of the ring, in their order. PLT_TILE: they fill one. */
static int finish_packets(plt_engine *d) {
    int status = PLT_OK;
    int32_t slot;
    while (status != PLT_TILE && (slot = plt_dispatch_oldest(&d->dispatch)) >= 0) {
        if (is_of_rays(d)) {
            d->dispatch.stats.bytes_back +=
                sizeof(plt_hit) * rays_from(d, d->dispatch.slot[slot].item[0]);
        } else {
            const uint32_t side = d->options.packet_side;
            d->dispatch.stats.bytes_back += 3 * side * side;
            status = plt_frame_take(&d->rendering, colours_of(d, (uint32_t)slot));
        }
        plt_dispatch_remove(&d->dispatch);
    }
    return status;
}

/* As far as their headers say, without the padding at the end. */
static int is_same_image(const plt_info *a, const plt_info *b) {
    return memcmp(a, b, offsetof(plt_info, has_checks) + 1) == 0;
}

/* Workers trace the dispatcher's packets in the dispatcher's scene. */
static int fits(const plt_engine *d, const plt_engine *w) {
    return d->dispatch.most > 0 && w->is_worker &&
           w->options.packet_side == d->options.packet_side && w->scene.format == d->scene.format &&
           is_same_image(&w->scene.info, &d->scene.info);
}

int plt_task_next(plt_engine *d, plt_engine *w) {
    if (!fits(d, w)) {
        return PLT_ERR_ARGUMENT;
    }
    int status = plt_dispatch_give(&d->dispatch, &w->worker);
    if (status < 0) { /* others may still be running */
        d->rendering.done = 1;
        d->shared.next = d->shared.count;
    }
    if (status != PLT_OK) {
        return status;
    }
    plt_traversal_drop(&w->traversal); /* of a task that was dropped, or failed */
    if (!is_of_rays(d) && plt_frame_ended(&d->rendering)) {
        return PLT_OK;
    }
    if (finish_packets(d) == PLT_TILE) {
        return PLT_TILE;
    }
    add_packets(d);
    return plt_dispatch_take(&d->dispatch, &w->worker, &w->traversal);
}

int plt_trace_begin(plt_engine *d, const plt_ray *rays, plt_hit *hits, uint32_t count, int any) {
    if (d->dispatch.most == 0) {
        return PLT_ERR_ARGUMENT;
    }
    d->rendering.done = 1;
    plt_task_drop(d);
    const plt_task_rays shared = {rays, count > 0 ? hits : NULL, count, 0, any};
    d->shared = shared;
    return PLT_OK;
}

/* ---- alone ------------------------------------------------------------------------------ */

int plt_task_step(plt_engine *e, uint32_t visits) {
    const int status = plt_task_next(e, e);
    if (status == PLT_MORE) {
        plt_task_run(e, e, visits);
    }
    return status;
}

int plt_task_trace(plt_engine *e, const plt_ray *rays, plt_hit *hits, uint32_t count, int any) {
    int status = plt_trace_begin(e, rays, hits, count, any);
    while (status >= PLT_OK && (status = plt_task_step(e, UINT32_MAX)) != PLT_OK) {
    }
    return status;
}

void plt_task_stats_get(const plt_engine *d, plt_task_stats *stats) {
    *stats = d->dispatch.stats;
}
