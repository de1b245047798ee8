/* coherence - see coherence.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/coherence.h"

#include "engine/lanes/lanes.h"

/* One ray of so many is looked at; odd, so that no pattern of 2, 4, 8 rays hides from it. */
#define SAMPLED 5

/* Least and greatest of each component; the fourth is something else. */
typedef struct extent {
    f4 lo, hi;
} extent;

/* A NaN leaves both as they were: of a NaN and a number min and max give the second. */
static inline void add(extent *e, f4 v) {
    e->lo = f4_min(v, e->lo);
    e->hi = f4_max(v, e->hi);
}

static float largest3(f4 v) {
    float lane[4];
    f4_store(lane, v);
    const float xy = lane[0] > lane[1] ? lane[0] : lane[1];
    return xy > lane[2] ? xy : lane[2];
}

/* Of rays that are looked at. */
typedef struct beam {
    extent org, dir;
} beam;

static beam no_beam(void) {
    const f4 far = f4_all(PLT_BOX_FAR);
    const extent none = {far, f4_neg(far)};
    const beam b = {none, none};
    return b;
}

static int is_narrow(const beam *b, const plt_box *scene, float narrow) {
    const float size = plt_box_longest_side(scene);
    const float length = largest3(f4_max(f4_abs(b->dir.lo), f4_abs(b->dir.hi)));
    const float apart = largest3(f4_sub(b->org.hi, b->org.lo));
    const float wide = largest3(f4_sub(b->dir.hi, b->dir.lo));
    /* apart / size + wide / length, without a division by 0. Infinite origins or directions
     * (also 0 * infinity) make them incoherent; of both it may say either: hits are the same. */
    return apart * length + wide * size <= narrow * size * length;
}

int plt_rays_are_narrow(const plt_ray *rays, uint32_t count, const plt_box *scene, float narrow) {
    beam b = no_beam();
    for (uint32_t i = 0; i < count; i += SAMPLED) {
        const float *ray = (const float *)&rays[i]; /* org tmin dir tmax, without gaps */
        add(&b.org, f4_load(ray));
        add(&b.dir, f4_load(ray + 4));
    }
    return is_narrow(&b, scene, narrow);
}

static void add_lane(extent *e, const float from[3][4], unsigned lane) {
    const float v[4] = {from[0][lane], from[1][lane], from[2][lane], 0.0f};
    add(e, f4_load(v));
}

int plt_packet_is_narrow(const plt_packet *p, float narrow) {
    beam b = no_beam();
    for (uint32_t i = 0; i < 4 * p->groups; i += SAMPLED) {
        const plt_group_rays *g = &p->rays[i / 4];
        if (g->valid >> i % 4 & 1u) {
            add_lane(&b.org, g->org, i % 4);
            add_lane(&b.dir, g->dir, i % 4);
        }
    }
    return is_narrow(&b, p->scene, narrow);
}
