/* shadows - see shadows.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/whitted/shadows.h"

#include "engine/whitted/direct.h"
#include "engine/whitted/optics.h"

#if PLT_WITH_WHITTED

void plt_shadows_begin(plt_whitted *w) {
    for (uint32_t i = 0; i < w->rays; i++) {
        plt_lit_shadow *s = &w->shadow[w->slot[i]];
        *s = (plt_lit_shadow){.through = {1, 1, 1}, .inside = w->pixel[w->slot[i]].ray.inside};
    }
}

/* Which glass the ray is in on the other side of `m`, and what it has lost on the way, `distance`
 * long, and by what the surface reflects. */
static void cross(const plt_whitted *w, plt_lit_shadow *s, const plt_material *m, uint32_t number,
                  float distance, float cosine) {
    plt_material left = *m;
    float share[3];
    if (s->inside > 0) {
        plt_materials_get(&w->materials, s->inside - 1u, &left);
    }
    const float passes = m->transparency * (1.0f - plt_optics_glass(left.index, cosine));
    for (int c = 0; c < 3; c++) {
        share[c] = s->inside > 0 ? passes * plt_optics_fade(left.absorption[c] * distance) : passes;
        s->through[c] *= share[c];
    }
    s->inside = s->inside > 0 ? 0 : (uint16_t)(number + 1u);
    s->surfaces++;
}

/* 0: no light comes this way. */
static int goes_on(const plt_whitted *w, plt_lit_shadow *s, const plt_packet *packet,
                   uint32_t ray) {
    const plt_group_rays *g = &packet->rays[ray / 4];
    const unsigned lane = ray % 4;
    const uint32_t number = plt_materials_find(&w->materials, g->id[lane]);
    plt_material m;
    plt_materials_get(&w->materials, number, &m);
    if (!(m.transparency > 0.0f) || s->surfaces >= PLT_SHADOW_SURFACES) {
        return 0;
    }
    const float t = packet->slabs.group[ray / 4].tmax[lane];
    float dir[3], n[3];
    for (int a = 0; a < 3; a++) {
        dir[a] = g->dir[a][lane];
        n[a] = g->normal[a][lane];
    }
    const float length = __builtin_sqrtf(plt_optics_dot(dir, dir));
    const int has_one = plt_normalise(n) && plt_normalise(dir);
    const float cosine = has_one ? __builtin_fabsf(plt_optics_dot(n, dir)) : 1.0f;
    cross(w, s, &m, number, (t - s->from) * length, cosine);
    s->from = t + w->lift / length;
    return plt_lit_counts(s->through);
}

uint32_t plt_shadows_take(plt_whitted *w, const plt_packet *packet) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < w->rays; i++) {
        const uint8_t k = w->slot[i];
        plt_lit_shadow *s = &w->shadow[k];
        if (packet->rays[i / 4].id[i % 4] == PLT_MISS) {
            plt_direct_add(w, &w->pixel[k], s->through);
        } else if (goes_on(w, s, packet, i)) {
            w->slot[count++] = k;
        }
    }
    return count;
}

#endif
