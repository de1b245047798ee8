/* wave_state - see wave_state.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/wave_state.h"

#include <string.h>

#include "engine/base/small_stack.h"
#include "engine/trace/coherence.h"
#include "engine/trace/ray_bounds.h"
#include "engine/trace/ray_packets.h"
#include "engine/trace/triangle_common.h"

/* By signs of a direction, bit 0 for x, plus 8 * the axis of its largest component. */
static const plt_wave_offsets offsets[24] = {
    {{0, 32, 64}, {16, 48, 80}, {4, 8, 0}}, {{16, 32, 64}, {0, 48, 80}, {4, 8, 0}},
    {{0, 48, 64}, {16, 32, 80}, {4, 8, 0}}, {{16, 48, 64}, {0, 32, 80}, {4, 8, 0}},
    {{0, 32, 80}, {16, 48, 64}, {4, 8, 0}}, {{16, 32, 80}, {0, 48, 64}, {4, 8, 0}},
    {{0, 48, 80}, {16, 32, 64}, {4, 8, 0}}, {{16, 48, 80}, {0, 32, 64}, {4, 8, 0}},
    {{0, 32, 64}, {16, 48, 80}, {8, 0, 4}}, {{16, 32, 64}, {0, 48, 80}, {8, 0, 4}},
    {{0, 48, 64}, {16, 32, 80}, {8, 0, 4}}, {{16, 48, 64}, {0, 32, 80}, {8, 0, 4}},
    {{0, 32, 80}, {16, 48, 64}, {8, 0, 4}}, {{16, 32, 80}, {0, 48, 64}, {8, 0, 4}},
    {{0, 48, 80}, {16, 32, 64}, {8, 0, 4}}, {{16, 48, 80}, {0, 32, 64}, {8, 0, 4}},
    {{0, 32, 64}, {16, 48, 80}, {0, 4, 8}}, {{16, 32, 64}, {0, 48, 80}, {0, 4, 8}},
    {{0, 48, 64}, {16, 32, 80}, {0, 4, 8}}, {{16, 48, 64}, {0, 32, 80}, {0, 4, 8}},
    {{0, 32, 80}, {16, 48, 64}, {0, 4, 8}}, {{16, 32, 80}, {0, 48, 64}, {0, 4, 8}},
    {{0, 48, 80}, {16, 32, 64}, {0, 4, 8}}, {{16, 48, 80}, {0, 32, 64}, {0, 4, 8}},
};

/* Columns of four rays, a row for each. */
static void store_rows(f4 a, f4 b, f4 c, f4 d, float to[4][4]) {
    f4 row[4] = {a, b, c, d};
    f4_transpose(&row[0], &row[1], &row[2], &row[3]);
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        f4_store(to[i], row[i]);
    }
}

/* The largest components of dir. */
static f4 along_of(const plt_group_rays *g) {
    const m4 is_x = m4_bits(g->axis_lanes[0]), is_y = m4_bits(g->axis_lanes[1]);
    const f4 x = f4_load(g->dir[0]), y = f4_load(g->dir[1]), z = f4_load(g->dir[2]);
    return f4_select(is_x, x, f4_select(is_y, y, z));
}

/* Of edge functions: 320 u^2 reach^2. */
static f4 least_slack_of(const plt_group_rays *g) {
    const f4 reach = f4_load(g->reach);
    return f4_mul(f4_mul(reach, reach), f4_all(PLT_CLOSE_ERROR));
}

static void stage_offsets(plt_wave_staged *to, const plt_group_slabs *s, const plt_group_rays *g) {
    unsigned negative[3];
    for (int a = 0; a < 3; a++) {
        negative[a] = m4_mask(f4_lt(f4_load(s->rdir[a]), f4_zero()));
    }
    for (unsigned i = 0; i < 4; i++) {
        const unsigned signs =
            (negative[0] >> i & 1u) | (negative[1] >> i & 1u) << 1 | (negative[2] >> i & 1u) << 2;
        const unsigned y = g->axis_lanes[1] >> i & 1u, z = g->axis_lanes[2] >> i & 1u;
        to->offsets[i] = (uint8_t)(signs + 8 * y + 16 * z);
    }
}

/* The group in which ray `number` is set up. */
static inline uint32_t group_of(const plt_wave_job *job, uint32_t number) {
    return job->rays != NULL ? 0 : number / 4;
}

/* Sets four rays up; lanes without one, and rays that hit nothing, are not valid. */
PLT_APART_ON_SMALL_STACKS static void stage(plt_wave_job *job) {
    plt_wave_staged *to = &job->wave->staged;
    plt_packet *p = job->packet;
    const uint32_t group = group_of(job, job->next);
    const plt_group_slabs *s = &p->slabs.group[group];
    const plt_group_rays *g = &p->rays[group];
    if (job->rays != NULL) {
        plt_packet_begin(p, &job->traversal->scene->box, 1, job->any);
        plt_packet_load_rays(p, 0, job->rays + job->next, job->count - job->next);
    }
    to->valid = g->valid;
    if (g->valid == 0) {
        return;
    }
    plt_group_make_ready(p, group);
    store_rows(f4_load(g->org[0]), f4_load(g->org[1]), f4_load(g->org[2]), f4_load(g->reach),
               to->org);
    store_rows(f4_load(g->slope[0]), f4_load(g->slope[1]), least_slack_of(g), along_of(g),
               to->shear);
    stage_offsets(to, s, g);
}

/* A ray out of its lane. */
PLT_APART_ON_SMALL_STACKS static void set_ray(plt_wave_ray *r, const plt_wave_job *job,
                                              uint32_t number) {
    const plt_wave_staged *from = &job->wave->staged;
    const plt_group_slabs *s = &job->packet->slabs.group[group_of(job, number)];
    const unsigned lane = number & 3u;
    r->number = number;
    PLT_UNROLLED for (unsigned a = 0; a < 3; a++) {
        f4_store(r->near_org[a], f4_all(s->near_org[a][lane]));
        f4_store(r->far_org[a], f4_all(s->far_org[a][lane]));
        f4_store(r->rdir[a], f4_all(s->rdir[a][lane]));
    }
    f4_store(r->tmin, f4_all(s->tmin[lane]));
    f4_store(r->tmax, f4_all(s->tmax[lane]));
    f4_store(r->org, f4_load(from->org[lane]));
    f4_store(r->slope, f4_load(from->shear[lane]));
    r->at = offsets[from->offsets[lane]];
}

/* Asks for the rays that come PLT_WAVE_AHEAD later: four take two lines. */
static void ask_ahead(const plt_wave_job *job) {
    if (job->rays == NULL) {
        return;
    }
    const uint32_t left = job->count - job->next;
    const plt_ray *ahead = &job->rays[job->next + (left > PLT_WAVE_AHEAD + 2 ? PLT_WAVE_AHEAD : 0)];
    plt_prefetch(ahead);
    plt_prefetch(ahead + (left > 2 ? 2 : 0));
}

/* Of the rays that plt_trace was given. */
static plt_wave_density *density_of(const plt_wave_job *job) {
    return &job->wave->density[job->any ? PLT_WAVE_GIVEN_ANY : PLT_WAVE_GIVEN];
}

static int goes_in_packets(plt_wave_job *job, const plt_ray *rays, uint32_t count) {
    const plt_scene *scene = job->traversal->scene;
    if (job->window.rays == 0) {
        return 0;
    }
    if (scene->bvh4 == NULL && scene->format == PLT_FORMAT_COMPACT) { /* dense or not */
        return plt_rays_are_narrow(rays, count, &scene->box, PLT_COHERENCE_NARROW_IN_BLOCKS);
    }
    if (plt_wave_density_is_high(density_of(job), count)) {
        /* The first are not in flight yet when the next are looked at. */
        job->wave->watched_rays = job->is_begun && count == job->window.rays ? count : 0;
        return 0;
    }
    return plt_rays_are_coherent(rays, count, &scene->box);
}

/* Of a window that packets would have had: it is traced, but for what is in flight. */
static void learn_alone(const plt_wave_job *job) {
    plt_wave *w = job->wave;
    if (w->watched_rays > 0) {
        plt_wave_density_alone(density_of(job), w->watched_rays,
                               job->traversal->stats.node_visits - w->visits_before);
    }
    w->watched_rays = 0;
}

/* A window in packets, of which the wave learns how dense boxes are. */
static int trace_window(plt_wave_job *job, const plt_ray *rays, uint32_t count) {
    plt_traversal *t = job->traversal;
    const uint64_t visits = t->stats.node_visits;
    const int status = plt_trace_packets(t, job->packet, job->window.packet_rays, rays,
                                         job->hits + job->next, count, job->any);
    plt_wave_density_packets(density_of(job), &job->window, job->any, count,
                             t->stats.node_visits - visits);
    return status;
}

int plt_wave_look(plt_wave_job *job) {
    plt_traversal *t = job->traversal;
    int status = PLT_OK;
    learn_alone(job);
    while (job->next == job->seen && job->next < job->count && status == PLT_OK) {
        const uint32_t left = job->count - job->next;
        const uint32_t window = job->window.rays, now = window > 0 && window < left ? window : left;
        const plt_ray *rays = job->rays + job->next;
        job->seen += now;
        if (goes_in_packets(job, rays, now)) {
            status = trace_window(job, rays, now);
            job->next = job->seen;
        } else {
            t->stats.rays += now;
            t->stats.wave_rays += now;
            job->wave->visits_before = t->stats.node_visits;
        }
    }
    return status;
}

/* Groups have missed already. */
static inline void set_missed(const plt_wave_job *job, uint32_t number) {
    const plt_hit miss = {0.0f, 0.0f, 0.0f, job->any ? 0 : PLT_MISS};
    if (job->rays != NULL) {
        job->hits[number] = miss;
    }
}

int plt_wave_take(plt_wave_job *job, plt_wave_ray *to) {
    while (job->next < job->seen) {
        const uint32_t number = job->next;
        if ((number & 3u) == 0) {
            ask_ahead(job);
            stage(job);
        }
        job->next++;
        set_missed(job, number);
        if (job->wave->staged.valid >> (number & 3u) & 1u) {
            set_ray(to, job, number);
            return 1;
        }
    }
    return 0;
}

/* Of a multiple of 16. */
static size_t rounded(size_t bytes) {
    return (bytes + 15) / 16 * 16;
}

static uint32_t ray_bytes(enum plt_wave_tree tree, uint32_t depth) {
    return (uint32_t)rounded(sizeof(plt_wave_ray) + plt_wave_stack_bytes(tree, depth));
}

static unsigned lists_of(enum plt_wave_tree tree) {
    return tree == PLT_WAVE_COMPACT ? PLT_WAVE_COMPACT_STEPS : PLT_WAVE_STEPS;
}

/* Bytes of a wave without its rays. */
static size_t lists_bytes(unsigned rays_in_flight, enum plt_wave_tree tree) {
    return rounded(sizeof(plt_wave)) +
           rounded(rays_in_flight *
                   (sizeof(plt_wave_found) + lists_of(tree) * sizeof(plt_wave_ray *)));
}

uint64_t plt_wave_bytes(unsigned rays_in_flight, enum plt_wave_tree tree, uint32_t depth) {
    return lists_bytes(rays_in_flight, tree) + (uint64_t)rays_in_flight * ray_bytes(tree, depth);
}

void plt_wave_init(void *memory, unsigned rays_in_flight, enum plt_wave_tree tree, uint32_t depth) {
    plt_wave *w = memory;
    unsigned char *at = (unsigned char *)memory + rounded(sizeof(plt_wave));
    w->rays_in_flight = rays_in_flight;
    w->ray_bytes = ray_bytes(tree, depth);
    memset(w->on, 0, sizeof w->on);
    memset(w->density, 0, sizeof w->density);
    w->taken = 0;
    w->found = (plt_wave_found *)(void *)at;
    at += rays_in_flight * sizeof *w->found;
    for (unsigned i = 0; i < lists_of(tree); i++) {
        w->list[i] = (plt_wave_ray **)(void *)at;
        at += rays_in_flight * sizeof *w->list[i];
    }
    w->first = (unsigned char *)memory + lists_bytes(rays_in_flight, tree);
}
