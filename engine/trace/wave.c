/* wave - see wave.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/wave.h"

#include <string.h>

#include "engine/trace/coherence.h"
#include "engine/trace/wave_bvh4.h"
#include "engine/trace/wave_compact.h"
#include "engine/trace/wave_thesis.h"

enum { WATCH_WINDOW = 256 }; /* rays: no packet has more */

/* PLT_OK: all rays are traced; or PLT_MORE: the step is over, or rays wait to be looked at. */
static int step(plt_wave_job *job) {
    const plt_scene *scene = job->traversal->scene;
    if (scene->bvh4 != NULL) {
        return plt_wave_bvh4(job);
    }
    if (scene->format == PLT_FORMAT_COMPACT) {
        PLT_IF(PLT_WITH_WAVE_COMPACT, return plt_wave_compact(job);)
    }
    PLT_IF(PLT_WITH_THESIS, return plt_wave_thesis(job);)
    return PLT_OK;
}

/* Nothing is on a list, whatever was under way. */
static void clear(plt_wave *w) {
    memset(w->on, 0, sizeof w->on);
    w->taken = 0;
    w->watched_rays = 0;
}

int plt_wave_trace(plt_traversal *t, plt_packet *packet, uint32_t most, int looks,
                   const plt_ray *rays, plt_hit *hits, uint32_t count, int any) {
    const uint32_t window = most > PLT_COHERENCE_WINDOW ? most : PLT_COHERENCE_WINDOW;
    plt_wave_job job = {.wave = t->wave,
                        .traversal = t,
                        .packet = packet,
                        .window = {looks ? window : 0, most},
                        .rays = rays,
                        .hits = hits,
                        .count = count,
                        .any = any,
                        .visits = UINT32_MAX};
    int status = PLT_OK;
    clear(job.wave);
    do {
        status = status == PLT_OK ? plt_wave_look(&job) : status;
        job.count = status == PLT_OK ? job.count : job.next; /* the wave ends its own rays */
    } while (step(&job) == PLT_MORE);
    return status;
}

void plt_wave_packet_begin(plt_traversal *t, uint32_t rays) {
    clear(t->wave);
    t->stats.rays += rays;
    t->stats.wave_rays += rays;
}

int plt_wave_packet_step(plt_traversal *t, plt_packet *packet, uint32_t visits) {
    plt_wave *w = t->wave;
    plt_wave_job job = {.wave = w,
                        .traversal = t,
                        .packet = packet,
                        .count = 4 * packet->groups,
                        .next = w->taken,
                        .seen = 4 * packet->groups,
                        .any = packet->any,
                        .is_begun = w->taken > 0,
                        .visits = visits};
    const int status = step(&job);
    w->taken = job.next;
    return status;
}

int plt_wave_suits(plt_traversal *t, const plt_packet *packet, enum plt_wave_kind kind) {
    plt_wave_density *d = &((plt_wave *)t->wave)->density[kind];
    const uint32_t rays = 4 * packet->groups;
    if (t->scene->bvh4 == NULL && t->scene->format == PLT_FORMAT_COMPACT) {
        return !plt_packet_is_narrow(packet, PLT_COHERENCE_NARROW_IN_BLOCKS);
    }
    if (plt_wave_density_is_high(d, rays)) {
        return 1;
    }
    return !plt_packet_is_narrow(packet, PLT_COHERENCE_NARROW);
}

void plt_wave_watch(plt_traversal *t, enum plt_wave_kind kind, uint32_t rays) {
    plt_wave *w = t->wave;
    w->watched = kind;
    w->watched_rays = rays;
    w->visits_before = t->stats.node_visits;
}

void plt_wave_watch_end(plt_traversal *t, int any) {
    plt_wave *w = t->wave;
    const plt_wave_window window = {WATCH_WINDOW, w->watched_rays};
    plt_wave_density_packets(&w->density[w->watched], &window, any, w->watched_rays,
                             t->stats.node_visits - w->visits_before);
}
