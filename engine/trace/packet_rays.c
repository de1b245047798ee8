/* packet_rays - see packet_rays.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/packet_rays.h"

#include <string.h>

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

/* Four hits: rows of t, u, v and id, as they lie in a hit file. Lanes without a
 * ray may hold garbage; it is masked out. */
static void store_group(const plt_packet *p, unsigned index, plt_hit hits[4]) {
    const plt_group_rays *g = &p->rays[index];
    const u4 miss = u4_all(PLT_MISS), id = u4_load(g->id);
    const m4 found = m4_andnot(m4_bits(g->valid), u4_eq(id, miss));
    const m4 wanted = p->any ? m4_bits(0) : found;
    const u4 name = p->any ? u4_select(found, u4_all(1), u4_all(0)) : u4_select(found, id, miss);
    f4 row[4] = {f4_select(wanted, f4_load(p->slabs.group[index].tmax), f4_zero()),
                 f4_select(wanted, f4_load(g->u), f4_zero()),
                 f4_select(wanted, f4_load(g->v), f4_zero())};
    uint32_t bits[4];
    u4_store(bits, name);
    row[3] = f4_load((const float *)(const void *)bits); /* bits are moved, not computed with */
    f4_transpose(&row[0], &row[1], &row[2], &row[3]);
    for (int i = 0; i < 4; i++) {
        f4_store((float *)(void *)&hits[i], row[i]);
    }
}

void plt_packet_store(const plt_packet *p, plt_hit *hits, uint32_t count) {
    plt_hit last[4];
    uint32_t i = 0;
    for (; i + 4 <= count; i += 4) {
        store_group(p, i / 4, hits + i);
    }
    if (i < count) {
        store_group(p, i / 4, last);
        memcpy(hits + i, last, (count - i) * sizeof *hits);
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

void plt_packet_load(plt_packet *p, const plt_box *scene, const plt_ray *rays, uint32_t count,
                     int any) {
    plt_packet_begin(p, scene, (count + 3) / 4, any);
    for (unsigned i = 0; i < p->groups; i++) {
        plt_packet_load_rays(p, i, rays + 4 * i, count - 4 * i);
    }
    plt_packet_finish(p);
    ask_ahead(rays, count);
}
