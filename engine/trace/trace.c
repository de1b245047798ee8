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

/* Four hits: rows of t, u, v and number, as they lie in a hit file. Lanes that
 * hold no ray hold anything, and nothing of that is kept. */
static void store_group(const plt_group *g, int any, plt_hit hits[4]) {
    const u4 miss = u4_all(PLT_MISS), number = u4_load(g->source);
    const m4 found = m4_andnot(m4_bits(g->valid), u4_eq(number, miss));
    const m4 wanted = any ? m4_bits(0) : found;
    const u4 name = any ? u4_select(found, u4_all(1), u4_all(0)) : u4_select(found, number, miss);
    f4 row[4] = {f4_select(wanted, f4_load(g->tmax), f4_zero()),
                 f4_select(wanted, f4_load(g->u), f4_zero()),
                 f4_select(wanted, f4_load(g->v), f4_zero())};
    uint32_t bits[4];
    u4_store(bits, name);
    row[3] = f4_load((const float *)(const void *)bits); /* bits are moved, not reckoned with */
    f4_transpose(&row[0], &row[1], &row[2], &row[3]);
    for (int i = 0; i < 4; i++) {
        f4_store((float *)(void *)&hits[i], row[i]);
    }
}

static void store_hits(const plt_packet *p, plt_hit *hits, uint32_t count) {
    plt_hit last[4];
    uint32_t i = 0;
    for (; i + 4 <= count; i += 4) {
        store_group(&p->group[i / 4], p->any, hits + i);
    }
    if (i < count) {
        store_group(&p->group[i / 4], p->any, last);
        memcpy(hits + i, last, (count - i) * sizeof *hits);
    }
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
    store_hits(p, hits, count);
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
