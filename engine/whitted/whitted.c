/* whitted - see whitted.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/whitted/whitted.h"

#include <string.h>

#include "engine/whitted/bounce.h"
#include "engine/whitted/direct.h"
#include "engine/whitted/lights.h"
#include "engine/whitted/optics.h"
#include "engine/whitted/paint.h"
#include "engine/whitted/point.h"
#include "engine/whitted/rays_due.h"
#include "engine/whitted/shadows.h"

#if PLT_WITH_WHITTED

enum stage { STAGE_RAYS, STAGE_SHADOWS };

/* 2^-17 of the largest coordinate: a ray that leaves a triangle on one side does not meet it again
 * (DESIGN.md, 9.2). */
#define LIFT 7.62939453125e-6f

plt_whitted *plt_whitted_init(void *memory, unsigned side, unsigned bounces) {
    plt_whitted *w = memory;
    memset(w, 0, sizeof *w);
    w->pixels = side * side;
    w->room = (uint8_t)bounces;
    unsigned char *at = (unsigned char *)memory + PLT_WHITTED_ALIGNED(sizeof *w);
    w->pixel = (plt_lit_pixel *)(void *)at;
    at += PLT_WHITTED_ALIGNED(w->pixels * sizeof *w->pixel);
    w->waiting = (plt_lit_ray *)(void *)at;
    at += PLT_WHITTED_ALIGNED((size_t)w->pixels * bounces * sizeof *w->waiting);
    w->shadow = (plt_lit_shadow *)(void *)at;
    w->slot = at + PLT_WHITTED_ALIGNED(w->pixels * sizeof *w->shadow);
    return w;
}

static float larger_size(float a, float b) {
    const float size = __builtin_fabsf(b);
    return size > a ? size : a;
}

void plt_whitted_frame(plt_whitted *w, const plt_box *box, const float eye[3], const float up[3]) {
    float most = 0.0f;
    w->box = box;
    for (int a = 0; a < 3; a++) {
        w->up[a] = up[a];
        most = larger_size(most, eye[a]);
        if (box->lo[a] <= box->hi[a]) {
            most = larger_size(larger_size(most, box->lo[a]), box->hi[a]);
        }
    }
    plt_normalise(w->up);
    w->lift = most * LIFT;
    w->is_traced = 0;
}

void plt_whitted_pixel_set(plt_whitted *w, uint32_t k, const float dir[3], uint8_t turn) {
    plt_lit_pixel *p = &w->pixel[k];
    memset(p, 0, sizeof *p);
    p->state = PLT_LIT_RAY;
    p->turn = turn;
    for (int a = 0; a < 3; a++) {
        p->ray.dir[a] = dir[a];
        p->ray.weight[a] = 1.0f;
    }
    plt_normalise(p->ray.dir);
}

void plt_whitted_pixel_none(plt_whitted *w, uint32_t k) {
    memset(&w->pixel[k], 0, sizeof w->pixel[k]);
}

void plt_whitted_begin(plt_whitted *w, const plt_packet *packet, uint32_t rays) {
    w->rays = rays;
    for (uint32_t k = 0; k < rays; k++) {
        w->slot[k] = (uint8_t)k;
    }
    w->is_empty = packet->active == 0;
    w->is_traced = 1;
#if PLT_WITH_WAVE
    w->by_wave = w->is_watched = 0;
#endif
    w->stage = STAGE_RAYS;
}

/* Glass takes its share of a ray that ran through it for t, its direction being of length 1. */
static void fade(const plt_whitted *w, plt_lit_pixel *p, float t) {
    plt_material m;
    if (p->ray.inside == 0) {
        return;
    }
    plt_materials_get(&w->materials, p->ray.inside - 1u, &m);
    for (int c = 0; c < 3; c++) {
        p->ray.weight[c] *= plt_optics_fade(m.absorption[c] * t);
    }
}

static int take_hit(plt_whitted *w, plt_traversal *traversal, plt_lit_pixel *p,
                    const plt_packet *packet, uint32_t slot) {
    const plt_group_rays *g = &packet->rays[slot / 4];
    const unsigned lane = slot % 4;
    const float t = packet->slabs.group[slot / 4].tmax[lane];
    for (int a = 0; a < 3; a++) {
        p->ray.org[a] = g->org[a][lane] + t * g->dir[a][lane];
    }
    fade(w, p, t);
#if PLT_WITH_TEXTURE
    plt_surface_point surface;
    plt_paint_far(&p->ray, g, lane, t);
    const int status = plt_point_set(traversal, p, packet, slot, &surface);
#else
    const int status = plt_point_set(traversal, p, packet, slot);
#endif
    if (status != PLT_OK) {
        return status;
    }
    p->material = (uint8_t)plt_materials_find(&w->materials, g->id[lane]);
#if PLT_WITH_TEXTURE
    plt_paint_point(w, p, &surface);
#endif
    p->state = PLT_LIT_HIT;
    plt_direct_begin(w, p);
    return PLT_OK;
}

static void take_sky(const plt_whitted *w, plt_lit_pixel *p) {
    float sky[3];
    plt_light_sky(&w->lighting, plt_optics_dot(p->ray.dir, w->up), sky);
    plt_lit_add(p, p->ray.weight, sky);
    p->ray.is_sky = p->ray.level == 0;
    p->state = PLT_LIT_DONE;
}

static int take_hits(plt_whitted *w, plt_traversal *t, const plt_packet *packet) {
    int status = PLT_OK;
    for (uint32_t i = 0; i < w->rays && status == PLT_OK; i++) {
        plt_lit_pixel *p = &w->pixel[w->slot[i]];
        const plt_group_rays *g = &packet->rays[i / 4];
        if (p->state != PLT_LIT_RAY) {
            continue; /* beside the frame */
        }
        if (w->is_empty || !(g->valid >> i % 4 & 1u) || g->id[i % 4] == PLT_MISS) {
            take_sky(w, p);
        } else {
            status = take_hit(w, t, p, packet, i);
        }
    }
    w->stage = STAGE_SHADOWS;
    w->light = w->sample = 0;
    w->is_on_way = 0;
    return status;
}

static void next_sample(plt_whitted *w) {
    if (++w->sample >= w->lighting.light[w->light].samples) {
        w->sample = 0;
        w->light++;
    }
}

static void take_shadows(plt_whitted *w, const plt_packet *packet) {
    if (plt_shadows_are_clear(w)) {
        w->rays = plt_shadows_take(w, packet);
        w->is_on_way = w->rays > 0;
    } else {
        plt_direct_take(w, packet);
    }
    if (!w->is_on_way) {
        next_sample(w);
    }
}

/* The rays to the current sample, or those of them that go on. */
static void find_shadows(plt_whitted *w) {
    if (w->is_on_way) {
        return;
    }
    w->rays = plt_direct_find(w);
    if (plt_shadows_are_clear(w)) {
        plt_shadows_begin(w);
    }
}

static int trace(plt_whitted *w, plt_traversal *t, plt_packet *packet, uint32_t visits) {
    int status = w->is_empty ? PLT_OK : plt_rays_due_trace(w, t, packet, visits);
    if (status != PLT_OK) {
        return status;
    }
    w->is_traced = 0;
    if (w->stage == STAGE_RAYS) {
        status = take_hits(w, t, packet);
    } else {
        take_shadows(w, packet);
    }
    return status == PLT_OK ? plt_paint_status(w) : status;
}

int plt_whitted_step(plt_whitted *w, plt_traversal *t, plt_packet *packet, uint32_t visits) {
    if (w->is_traced) {
        return trace(w, t, packet, visits);
    }
    if (w->light < w->lighting.lights) {
        find_shadows(w);
        if (w->rays > 0) {
            plt_rays_due_begin(w, t, packet, 1);
        } else {
            next_sample(w);
        }
        return PLT_MORE;
    }
    w->rays = plt_bounce_all(w);
    if (w->rays == 0) {
        return PLT_OK;
    }
    w->stage = STAGE_RAYS;
    plt_rays_due_begin(w, t, packet, 0);
    return PLT_MORE;
}

#endif
