/* packet_rays - see packet_rays.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/packet_rays.h"

#include <string.h>

#include "engine/trace/packet_plain.h"

_Static_assert(sizeof(plt_ray) == 32 && sizeof(plt_hit) == 16, "as in ray and hit files");

void plt_packet_load_rays(plt_packet *p, unsigned index, const plt_ray *rays, uint32_t count) {
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
    plt_packet_set_group(p, index, o, d, o[3], d[3], count);
}

/* Code of its own for hits and for any hit, where that is short. */
#if PLT_LANES_REGISTERS
#define FOR_EACH_KIND PLT_INLINED
#else
#define FOR_EACH_KIND static
#endif

/* Four hits: rows of t, u, v and id, as they lie in a hit file, but of any hit 1 for its id, and
 * nothing else. Lanes without a ray have missed. */
FOR_EACH_KIND void store_group(const plt_group_slabs *s, const plt_group_rays *g, int any,
                               plt_hit hits[4]) {
    const u4 id = u4_load(g->id);
    const m4 missed = u4_eq(id, u4_all(PLT_MISS));
    f4 row[4] = {f4_zero(), f4_zero(), f4_zero(), f4_zero()};
    uint32_t name[4];
    u4_store(name, any ? u4_select(missed, u4_all(0), u4_all(1)) : id);
    row[3] = f4_load((const float *)(const void *)name); /* bits are moved, not computed with */
    if (!any) {
        row[0] = f4_select(missed, f4_zero(), f4_load(s->tmax));
        row[1] = f4_select(missed, f4_zero(), f4_load(g->u));
        row[2] = f4_select(missed, f4_zero(), f4_load(g->v));
    }
    f4_transpose(&row[0], &row[1], &row[2], &row[3]);
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        f4_store((float *)(void *)&hits[i], row[i]);
    }
}

FOR_EACH_KIND void store_kind(const plt_packet *p, plt_hit *hits, uint32_t count, int any) {
    const plt_group_slabs *s = p->slabs.group;
    const plt_group_rays *g = p->rays;
    uint32_t left = count;
    for (; left > 4; left -= 4) {
        store_group(s++, g++, any, hits);
        hits += 4;
    }
    plt_hit last[4];
    store_group(s, g, any, last);
    memcpy(hits, last, left * sizeof *hits);
}

void plt_packet_store(const plt_packet *p, plt_hit *hits, uint32_t count) {
    if (!PLT_LANES_REGISTERS) {
        store_kind(p, hits, count, p->any);
    } else if (p->any) {
        store_kind(p, hits, count, 1);
    } else {
        store_kind(p, hits, count, 0);
    }
}

/* Asks for as many rays behind these, which the processor does not guess while it traces. They
 * may lie beyond the last: no prefetch minds. */
static void ask_ahead(const plt_ray *rays, uint32_t count) {
    const uintptr_t next = (uintptr_t)rays + count * sizeof *rays;
    for (uint32_t i = 0; i < count; i += 2) {
        plt_prefetch((const void *)(next + i * sizeof *rays));
    }
}

void plt_packet_set_rays(plt_packet *p, const plt_box *scene, const plt_ray *rays, uint32_t count,
                         int any) {
    plt_packet_begin(p, scene, (count + 3) / 4, any);
#if PLT_WITH_HULLS
    if (plt_packet_set_plain(p, rays, count)) {
        return; /* it asks ahead itself */
    }
#endif
    for (unsigned i = 0; i < p->groups; i++) {
        plt_packet_load_rays(p, i, rays + 4 * i, count - 4 * i);
    }
    plt_packet_finish(p);
    ask_ahead(rays, count);
}
