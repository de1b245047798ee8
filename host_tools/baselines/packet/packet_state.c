/* packet_state - see packet_state.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/packet/packet_state.h"

#include <math.h>
#include <string.h>

#include "engine/trace/packet_rays.h"
#include "host_tools/base/heap.h"

int packet_open(packet_state *p, uint32_t side) {
    memset(p, 0, sizeof *p);
    p->side = side == 0 ? 8 : side;
    p->side = p->side < PLT_PACKET_SIDE_MAX ? p->side : PLT_PACKET_SIDE_MAX;
    p->memory = heap_get_aligned(plt_packet_bytes(p->side));
    if (p->memory == NULL) {
        return -1;
    }
    plt_packet_init(&p->rays, p->memory, p->side);
    return 0;
}

void packet_close(packet_state *p) {
    heap_drop(p->memory);
    p->memory = NULL;
}

/* ---- the hull ------------------------------------------------------------------- */

/* Of all groups so far, lane by lane. */
typedef struct hull_lanes {
    f4 near_most[3], far_least[3], rate_least[3], rate_most[3];
    f4 enter, leave;
} hull_lanes;

static float least_of(f4 v) {
    return f4_min_lane(v);
}

static float most_of(f4 v) {
    return -f4_min_lane(f4_neg(v));
}

static void lanes_begin(hull_lanes *h) {
    const f4 most = f4_all(INFINITY), least = f4_all(-INFINITY);
    for (int a = 0; a < 3; a++) {
        h->near_most[a] = h->rate_most[a] = least;
        h->far_least[a] = h->rate_least[a] = most;
    }
    h->enter = most;
    h->leave = least;
}

/* Lanes without a ray say nothing. */
static inline f4 spread_valid(m4 valid, f4 v, unsigned is_backwards, float otherwise) {
    return f4_select(valid, is_backwards ? f4_neg(v) : v, f4_all(otherwise));
}

static void lanes_add(hull_lanes *h, const packet_state *p, unsigned group) {
    const plt_slab_array *all = &p->rays.slabs;
    const plt_group_slabs *s = &all->group[group];
    const m4 valid = m4_bits(p->rays.rays[group].valid);
    const int is_one = all->coherence == PLT_ONE_ORIGIN;
    for (int a = 0; a < 3; a++) {
        const unsigned back = all->negative[a];
        const f4 rate = f4_load(s->rdir[a]);
        h->rate_least[a] = f4_min(h->rate_least[a], spread_valid(valid, rate, back, INFINITY));
        h->rate_most[a] = f4_max(h->rate_most[a], spread_valid(valid, rate, back, -INFINITY));
        if (!is_one) { /* groups of one origin have none of their own */
            const f4 near_org = f4_load(s->near_org[a]), far_org = f4_load(s->far_org[a]);
            h->near_most[a] =
                f4_max(h->near_most[a], spread_valid(valid, near_org, back, -INFINITY));
            h->far_least[a] = f4_min(h->far_least[a], spread_valid(valid, far_org, back, INFINITY));
        }
    }
    h->enter = f4_min(h->enter, spread_valid(valid, f4_load(s->tmin), 0, INFINITY));
    h->leave = f4_max(h->leave, f4_load(s->tmax));
}

/* An axis along which rays go both ways has no part. */
static void hull_set_axis(packet_hull *to, const hull_lanes *h, const plt_slab_array *s, int a) {
    const int is_one = s->coherence == PLT_ONE_ORIGIN;
    const float sign = s->negative[a] ? -1.0f : 1.0f;
    to->near_most[a] = is_one ? sign * s->near_org[a] : most_of(h->near_most[a]);
    to->far_least[a] = is_one ? sign * s->far_org[a] : least_of(h->far_least[a]);
    to->rate_least[a] = least_of(h->rate_least[a]);
    to->rate_most[a] = most_of(h->rate_most[a]);
    to->has_part[a] = to->rate_least[a] > 0.0f ? 0xFFFFFFFFu : 0;
    to->backwards[a] = s->negative[a] ? 0xFFFFFFFFu : 0;
    to->enter[a] = -INFINITY;
    to->leave[a] = INFINITY;
}

static void hull_set(packet_state *p) {
    packet_hull *to = &p->hull;
    hull_lanes h;
    lanes_begin(&h);
    for (plt_mask m = p->rays.active; m != 0; m &= m - 1) {
        lanes_add(&h, p, plt_mask_first(m));
    }
    for (int a = 0; a < 3; a++) {
        hull_set_axis(to, &h, &p->rays.slabs, a);
    }
    to->near_most[3] = to->far_least[3] = 0.0f;
    to->rate_least[3] = to->rate_most[3] = 1.0f;
    to->has_part[3] = to->backwards[3] = 0;
    to->enter[3] = least_of(h.enter);
    to->leave[3] = most_of(h.leave);
}

void packet_narrow(packet_state *p) {
    f4 most = f4_all(-1.0f);
#if PLT_WITH_HULLS
    if (p->rays.changed == 0) {
        return;
    }
    p->rays.changed = 0;
#endif
    for (plt_mask m = p->rays.active; m != 0; m &= m - 1) {
        most = f4_max(most, f4_load(p->rays.slabs.group[plt_mask_first(m)].tmax));
    }
    p->hull.leave[3] = most_of(most);
}

/* ---- rays ------------------------------------------------------------------------- */

int packet_begin(packet_state *p, const plt_box *scene, const plt_ray *rays, uint32_t count,
                 int any) {
    plt_packet *r = &p->rays;
    plt_packet_set_rays(r, scene, rays, count, any);
    p->count = count;
    p->counts.rays += count;
    if (r->active == 0) {
        return 0;
    }
    plt_packet_make_ready(r);
    p->whole =
        (packet_range){(uint8_t)plt_mask_first(r->active), (uint8_t)plt_mask_last(r->active)};
    hull_set(p);
    p->counts.packets++;
    p->counts.signs += r->slabs.coherence != PLT_MIXED;
    return 1;
}

void packet_all(const packet_state *p, packet_mask *to) {
    packet_mask_clear(to);
    for (plt_mask m = p->rays.active; m != 0; m &= m - 1) {
        const unsigned group = plt_mask_first(m);
        packet_mask_add(to, group, p->rays.rays[group].valid);
    }
}

void packet_store(const packet_state *p, plt_hit *hits) {
    plt_packet_store(&p->rays, hits, p->count);
}

void packet_store_misses(plt_hit *hits, uint32_t count, int any) {
    for (uint32_t i = 0; i < count; i++) {
        hits[i] = (plt_hit){.triangle = any ? 0 : PLT_MISS};
    }
}
