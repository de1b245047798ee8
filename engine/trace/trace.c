/* trace - rays from an array to hits in an array
 *
 * SPDX-License-Identifier: MIT */
#include "engine/engine.h"

_Static_assert(sizeof(plt_ray) == 32 && sizeof(plt_hit) == 16, "as in ray and hit files");

/* Four rays, or fewer at the end of the array, into lanes. */
static void load_group(plt_engine *e, unsigned index, const plt_ray *rays, uint32_t count) {
    plt_ray four[4];
    if (count < 4) {
        for (uint32_t i = 0; i < 4; i++) {
            four[i] = rays[i < count ? i : 0];
        }
        rays = four;
    } else {
        count = 4;
    }
    f4 o[4], d[4];
    for (int i = 0; i < 4; i++) {
        const float *ray = (const float *)&rays[i]; /* org tmin dir tmax, without gaps */
        o[i] = f4_load(ray);
        d[i] = f4_load(ray + 4);
    }
    f4_transpose(&o[0], &o[1], &o[2], &o[3]);
    f4_transpose(&d[0], &d[1], &d[2], &d[3]);
    plt_group_set(&e->walker.packet, index, &e->walker.tree.box, o, d, o[3], d[3], count);
}

static void store_hit(const plt_group *g, unsigned lane, int any, plt_hit *hit) {
    const plt_hit miss = {0.0f, 0.0f, 0.0f, any ? 0 : PLT_MISS};
    *hit = miss;
    if (!(g->valid >> lane & 1u) || g->source[lane] == PLT_MISS) {
        return;
    }
    if (any) {
        hit->triangle = 1;
        return;
    }
    hit->t = g->tmax[lane];
    hit->u = g->u[lane];
    hit->v = g->v[lane];
    hit->triangle = g->source[lane];
}

static void trace_packet(plt_engine *e, const plt_ray *rays, plt_hit *hits, uint32_t count,
                         int any) {
    plt_packet *p = &e->walker.packet;
    plt_packet_begin(p, (count + 3) / 4, any);
    for (unsigned i = 0; i < p->groups; i++) {
        load_group(e, i, rays + 4 * i, count - 4 * i);
    }
    plt_packet_finish(p);
    plt_walk_begin(&e->walker);
    while (e->walker.waiting > 0) {
        plt_engine_walk(e, 0xFFFFFFFFu);
    }
    for (uint32_t i = 0; i < count; i++) {
        store_hit(&p->group[i / 4], i % 4, any, &hits[i]);
    }
    e->walker.stats.rays += count;
}

int plt_trace(plt_engine *e, const plt_ray *rays, plt_hit *hits, uint32_t count, int any) {
    const uint32_t most = (uint32_t)e->options.packet_side * e->options.packet_side;
    e->rendering.done = 1;
    while (count > 0) {
        const uint32_t now = count < most ? count : most;
        trace_packet(e, rays, hits, now, any);
        rays += now;
        hits += now;
        count -= now;
    }
    return PLT_OK;
}
