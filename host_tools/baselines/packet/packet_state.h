/* packet_state - a packet of rays on its way through an object hierarchy
 *
 * It is a packet of the engine (trace/packet.h): four rays to a group, the engine's test of
 * triangles, its origins and reciprocals. A reported hit lies in every box around its triangle by
 * the engine's own distances (trace/triangle.h), which are monotone in the planes: so whatever has
 * planes around whole triangles needs no other distances than these, and leaves out no hit.
 *
 * Beside it stands the hull of all its rays: by interval arithmetic, four axes at once, of which
 * the fourth is the ray itself, a box that none of them meets is turned away in one test.
 *
 * Rays of mixed signs stay together (thesis, section 3.5.3): near and far planes are chosen lane by
 * lane then, and the hull leaves axes of mixed signs out. The share of packets whose signs are
 * equal is counted.
 *
 * Sources: Karrenberg 2007, section 3.5; Boulos, Wald, Shirley, "Geometric and arithmetic culling
 * methods for entire ray packets", 2006 (intervals); Wald, Boulos, Shirley 2007, section 4.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_PACKET_STATE_H
#define BASELINES_PACKET_STATE_H

#include "engine/trace/packet.h"
#include "host_tools/baselines/packet/packet_counts.h"
#include "host_tools/baselines/packet/packet_mask.h"

/* [axis], and the ray in [3]. Along a backward axis planes and origins change their signs, so that
 * every rate is positive. */
typedef struct packet_hull {
    float near_most[4], far_least[4];  /* origins */
    float rate_least[4], rate_most[4]; /* what a step of 1 along an axis takes */
    float enter[4], leave[4];          /* where the axis has no part, and in [3] */
    uint32_t has_part[4];              /* all ones: the axis has one */
    uint32_t backwards[4];             /* all ones, likewise */
} packet_hull;

typedef struct packet_state {
    plt_packet rays;
    packet_hull hull;
    packet_counts counts;
    uint32_t side;      /* 2, 4, 8 or 16: rays along a side at most */
    uint32_t count;     /* rays that were given, valid or not */
    packet_range whole; /* groups with a ray */
    void *memory;       /* owned */
} packet_state;

/* For packets of side^2 rays; 0: 8; PLT_PACKET_SIDE_MAX at most. -1: no memory. */
int packet_open(packet_state *p, uint32_t side);
void packet_close(packet_state *p);

/* Takes up `count` rays, side^2 at most; whether one of them is a ray. `scene`: the box of all
 * triangles, not empty; it must stay where it is. */
int packet_begin(packet_state *p, const plt_box *scene, const plt_ray *rays, uint32_t count,
                 int any);

/* All rays, as far as they are. */
void packet_all(const packet_state *p, packet_mask *to);

/* The hits of all rays that were given, as plt_trace would say them. */
void packet_store(const packet_state *p, plt_hit *hits);

/* Those of `count` that no packet has to be made for. */
void packet_store_misses(plt_hit *hits, uint32_t count, int any);

/* Hits have been found: brings the hull up to date. */
void packet_narrow(packet_state *p);

/* Of a packet that goes one way along each axis, the direction of all rays, else of the first. */
static inline unsigned packet_is_backwards(const packet_state *p, unsigned axis) {
    return p->rays.slabs.negative[axis];
}

/* Rays of groups, an odd end left out. */
static inline uint32_t packet_rays_of(const packet_state *p, plt_mask groups) {
    const uint32_t last = (p->count - 1) / 4, odd = 4 * last + 4 - p->count;
    return 4 * plt_mask_count(groups) - (groups >> last & 1u ? odd : 0);
}

static inline uint32_t packet_range_rays(const packet_state *p, const packet_range *r) {
    const uint32_t end = 4u * r->last + 4u < p->count ? 4u * r->last + 4u : p->count;
    return r->first > r->last ? 0 : end - 4u * r->first;
}

#endif
