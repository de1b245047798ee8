/* rays_due - see rays_due.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/whitted/rays_due.h"

#include "engine/trace/wave.h"
#include "engine/whitted/direct.h"
#include "engine/whitted/point.h"
#include "engine/whitted/shadows.h"

#if PLT_WITH_WHITTED

#define FAR 3.0e38f /* tmax of rays without an end */

/* Four rays, [axis][lane]. */
typedef struct four {
    _Alignas(16) float org[3][4];
    _Alignas(16) float dir[3][4];
    _Alignas(16) float tmin[4], tmax[4];
} four;

static void put_ray(four *rays, unsigned lane, const float org[3], const float dir[3], float tmax) {
    for (int a = 0; a < 3; a++) {
        rays->org[a][lane] = org[a];
        rays->dir[a][lane] = dir[a];
    }
    rays->tmax[lane] = tmax;
}

static void set_lane(const plt_whitted *w, four *rays, uint32_t slot, int shadows) {
    const plt_lit_pixel *p = &w->pixel[w->slot[slot]];
    if (shadows) {
        float org[3], dir[3];
        const float tmax = plt_direct_ray(w, p, org, dir);
        put_ray(rays, slot % 4, org, dir, tmax);
        if (plt_shadows_are_clear(w)) {
            rays->tmin[slot % 4] = w->shadow[w->slot[slot]].from;
        }
    } else {
        put_ray(rays, slot % 4, p->ray.org, p->ray.dir, FAR);
    }
}

static void set_group(const plt_whitted *w, plt_packet *packet, uint32_t first, int shadows) {
    four rays = {{{0}}, {{0}}, {0}, {0}};
    const uint32_t left = w->rays - first, count = left < 4 ? left : 4;
    for (uint32_t i = 0; i < count; i++) {
        set_lane(w, &rays, first + i, shadows);
    }
    const f4 org[3] = {f4_load(rays.org[0]), f4_load(rays.org[1]), f4_load(rays.org[2])};
    const f4 dir[3] = {f4_load(rays.dir[0]), f4_load(rays.dir[1]), f4_load(rays.dir[2])};
    plt_packet_set_group(packet, first / 4, org, dir, f4_load(rays.tmin), f4_load(rays.tmax),
                         count);
}

#if PLT_WITH_WAVE
/* Whether rays that are set up are better traced each for itself. */
static int goes_by_wave(const plt_whitted *w, plt_traversal *t, const plt_packet *packet,
                        int shadows) {
    if (t->wave == NULL || w->rays_kind == PLT_RAYS_COHERENT) {
        return 0;
    }
    return w->rays_kind == PLT_RAYS_INCOHERENT ||
           plt_wave_suits(t, packet, shadows ? PLT_WAVE_SHADOWS : PLT_WAVE_BOUNCES);
}

/* How many visits they take says what the next ones had better do. */
static void watch(plt_whitted *w, plt_traversal *t, int shadows) {
    w->is_watched = t->wave != NULL && w->rays_kind == PLT_RAYS_AUTO;
    if (w->is_watched) {
        plt_wave_watch(t, shadows ? PLT_WAVE_SHADOWS : PLT_WAVE_BOUNCES, w->rays);
    }
}

/* 1: the wave has them. */
static int begin_wave(plt_whitted *w, plt_traversal *t, const plt_packet *packet, int shadows) {
    w->by_wave = goes_by_wave(w, t, packet, shadows) != 0;
    if (w->by_wave) {
        plt_wave_packet_begin(t, w->rays);
    } else {
        watch(w, t, shadows);
    }
    return w->by_wave;
}
#else
static int begin_wave(const plt_whitted *w, const plt_traversal *t, const plt_packet *packet,
                      int shadows) {
    (void)w;
    (void)t;
    (void)packet;
    (void)shadows;
    return 0;
}
#endif

void plt_rays_due_begin(plt_whitted *w, plt_traversal *t, plt_packet *packet, int shadows) {
    const int clear = plt_shadows_are_clear(w);
    plt_packet_begin(packet, w->box, (w->rays + 3) / 4, shadows && !clear);
    if (!shadows) {
        plt_point_want(t->scene, packet);
    } else if (clear) {
        plt_packet_want_normals(packet);
    }
    for (uint32_t first = 0; first < w->rays; first += 4) {
        set_group(w, packet, first, shadows);
    }
    if (!begin_wave(w, t, packet, shadows)) {
        plt_packet_finish(packet);
        plt_traversal_begin(t, packet, w->rays);
    }
    w->is_empty = 0;
    w->is_traced = 1;
}

#if PLT_WITH_WAVE
int plt_rays_due_trace(const plt_whitted *w, plt_traversal *t, plt_packet *packet,
                       uint32_t visits) {
    if (w->by_wave) {
        return plt_wave_packet_step(t, packet, visits);
    }
    const int status = plt_traverse(t, packet, visits);
    if (status == PLT_OK && w->is_watched) {
        plt_wave_watch_end(t, packet->any);
    }
    return status;
}
#endif

#endif
