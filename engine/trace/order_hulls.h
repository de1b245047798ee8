/* order_hulls - depth first, by the hulls of a packet
 *
 * One stack over the whole tree, like order_depth_first.h; an entry says which lanes of which
 * hull go there. Where a box is small beside a lane, the lane's own hull goes on instead
 * (adaptive refinement), so that the rays tested are about as many as the box could hold.
 * Leaves wait in a short queue while their lines arrive.
 *
 * The farther child waits with its depth of entry, which is all that is tested when its turn
 * comes. If any hit will do, the farther child goes first: it holds as many triangles, and
 * those near the origins are mostly behind the rays (measured, DESIGN.md, section 6.2).
 *
 * Include a format (format.h) before this file; it gives format_bounds and
 * format_child_bounds, too.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_ORDER_HULLS_H
#define PLT_TRACE_ORDER_HULLS_H

#if PLT_WITH_HULLS

#include "engine/trace/format_meets.h"
#include "engine/trace/hull_test.h"

/* Leaves are tested when so many wait, if they do. */
enum { HULLS_LEAVES = FORMAT_LEAVES_WAIT ? (int)PLT_LEAVES_WAITING : 1 };

typedef struct hulls_entry {
    format_place place;
    uint16_t hull;
    uint8_t lanes;
    f4 enter; /* depth of each lane at which it meets the box */
} hulls_entry;

/* The entry waits at its edge for other packets (format_meets.h). 0: it is to go on. */
static inline int hulls_wait(plt_traversal *t, const hulls_entry *e) {
#if FORMAT_MEETS
    if (!plt_meets(t) || format_is_leaf(&e->place) || !format_is_edge(&e->place)) {
        return 0;
    }
    const f4 enter = f4_select(m4_bits(e->lanes), e->enter, f4_all(0x1p127f));
    const f4 two = f4_min(f4_lane(enter, 0), f4_lane(enter, 1));
    float distance[4];
    f4_store(distance, f4_min(two, f4_min(f4_lane(enter, 2), f4_lane(enter, 3))));
    return format_wait(t, &e->place, distance[0], e, sizeof *e);
#else
    (void)t;
    (void)e;
    return 0;
#endif
}

/* Groups of the lanes of a hull that meet a box, hulls above the groups' first. */
PLT_INLINED plt_mask groups_below(const plt_packet *p, const plt_planes *planes, unsigned hull,
                                  unsigned lanes, unsigned lowest, enum plt_coherence kind) {
    uint16_t waiting[PLT_GROUPS_MAX / 4 + 4]; /* hull, and its lanes in the low bits */
    unsigned count = 0;
    plt_mask groups = 0;
    for (;;) {
        for (; lanes != 0; lanes &= lanes - 1) {
            f4 enter;
            const unsigned below = plt_hull_below(hull, plt_lane_first(lanes));
            const plt_four four = plt_four_of(p, below);
            const unsigned met = plt_four_meet(&four, planes, kind, &enter);
            if (below >= lowest) {
                groups |= (plt_mask)met << 4 * (below - lowest);
            } else if (met != 0) {
                waiting[count++] = (uint16_t)(below << 4 | met);
            }
        }
        if (count == 0) {
            return groups;
        }
        hull = waiting[--count] >> 4;
        lanes = waiting[count] & 15u;
    }
}

/* Groups of an entry that meet its box. */
PLT_INLINED plt_mask groups_of(const plt_traversal *t, const plt_packet *p, const hulls_entry *e,
                               unsigned lanes, enum plt_coherence kind) {
    if (e->hull >= p->first_group) {
        return plt_mask_of(e->hull - p->first_group, 1);
    }
    const unsigned lowest = (p->first_group - 1) / 4;
    if (e->hull >= lowest) {
        return (plt_mask)lanes << 4 * (e->hull - lowest);
    }
    plt_planes planes;
    f4 lo, hi;
    format_bounds(t, &e->place, &lo, &hi);
    plt_planes_set(&planes, &p->slabs, lo, hi, kind);
    return groups_below(p, &planes, e->hull, lanes, lowest, kind);
}

/* Lanes for which hits found since hide no box that is entered there. */
static inline unsigned still_open(const plt_packet *p, const hulls_entry *e) {
    const plt_four four = plt_four_of(p, e->hull);
    return e->lanes & m4_mask(f4_le(e->enter, f4_load(four.slabs->tmax)));
}

PLT_INLINED int test_leaf(plt_traversal *t, plt_packet *p, const hulls_entry *e,
                          enum plt_coherence kind) {
    const unsigned lanes = still_open(p, e);
    if (lanes == 0) {
        return PLT_OK;
    }
    const plt_mask groups = groups_of(t, p, e, lanes, kind) & p->active;
    return groups != 0 ? format_leaf(t, p, &e->place, groups) : PLT_OK;
}

/* Those that wait. Hulls learn of the hits when all are done. */
PLT_INLINED int test_leaves(plt_traversal *t, plt_packet *p, enum plt_coherence kind) {
    const hulls_entry *leaf = t->leaves;
    const unsigned count = t->leaves_waiting;
    int status = PLT_OK;
    t->leaves_waiting = 0;
    for (unsigned i = 0; i < count && status == PLT_OK && p->active != 0; i++) {
        status = test_leaf(t, p, &leaf[i], kind);
    }
    plt_hulls_narrow(p);
    return status;
}

/* Lanes beside which the box is small, or the only one. */
static inline unsigned lanes_to_refine(const plt_packet *p, const hulls_entry *e, f4 across) {
    const plt_hull *h = &p->hull[e->hull];
    const f4 width = f4_add(f4_mul(f4_load(h->narrow[0]), e->enter), f4_load(h->narrow[1]));
    const unsigned small = m4_mask(f4_lt(across, width)) & e->lanes;
    return (e->lanes & (e->lanes - 1u)) == 0 ? e->lanes : small;
}

/* The longer side of a box across the packet's axis. */
static inline f4 side_across(const plt_packet *p, f4 lo, f4 hi) {
    const f4 side = f4_mul(f4_sub(hi, lo), f4_load(p->across));
    return f4_max(f4_max(f4_lane(side, 0), f4_lane(side, 1)), f4_lane(side, 2));
}

/* All lanes but one wait, if there are more. */
static inline void leave_others(plt_traversal *t, const hulls_entry *at, unsigned lane) {
    hulls_entry *rest = (hulls_entry *)t->stack + t->waiting;
    *rest = *at;
    rest->lanes = at->lanes & (uint8_t) ~(1u << lane);
    t->waiting += rest->lanes != 0;
}

/* Goes on with lanes of hulls below where the box is small; the others wait. 0: none is met. */
PLT_INLINED int refine(plt_traversal *t, plt_packet *p, hulls_entry *at, enum plt_coherence kind) {
    f4 lo, hi;
    format_bounds(t, &at->place, &lo, &hi);
    const f4 across = side_across(p, lo, hi);
    unsigned small = lanes_to_refine(p, at, across);
    if (small == 0) {
        return 1;
    }
    plt_planes planes;
    plt_planes_set(&planes, &p->slabs, lo, hi, kind);
    do {
        const unsigned lane = plt_lane_first(small);
        leave_others(t, at, lane);
        at->hull = (uint16_t)plt_hull_below(at->hull, lane);
        if (at->hull >= p->first_group) {
            plt_group_make_ready(p, at->hull - p->first_group);
        }
        const plt_four four = plt_four_of(p, at->hull);
        at->lanes = (uint8_t)plt_four_meet(&four, &planes, kind, &at->enter);
        if (at->lanes == 0) {
            return 0;
        }
        small = at->hull < p->first_group ? lanes_to_refine(p, at, across) : 0;
    } while (small != 0);
    return 1;
}

/* 1: child 0 lies further on along the packet's direction. */
static inline unsigned first_is_farther(const plt_packet *p, const f4 lo[2], const f4 hi[2]) {
    const f4 apart = f4_sub(f4_add(lo[0], hi[0]), f4_add(lo[1], hi[1]));
    const f4 ahead = f4_mul(apart, f4_load(p->forward));
    const f4 sum = f4_add(f4_add(f4_lane(ahead, 0), f4_lane(ahead, 1)), f4_lane(ahead, 2));
    return m4_mask(f4_lt(f4_zero(), sum)) & 1u;
}

/* Both children of the node that `at` leads to, in the order in which they are to be visited,
 * with the lanes that meet them. */
PLT_INLINED void meet_children(plt_traversal *t, const plt_packet *p, const hulls_entry *at,
                               enum plt_coherence kind, hulls_entry *one, hulls_entry *two) {
    format_children c;
    f4 lo[2], hi[2], enter[2];
    unsigned met[2];
    const plt_four four = plt_four_of(p, at->hull);
    format_decode(t, &at->place, &c);
    PLT_UNROLLED for (unsigned i = 0; i < 2; i++) {
        plt_planes planes;
        format_child_bounds(&c, i, &lo[i], &hi[i]);
        plt_planes_set(&planes, &p->slabs, lo[i], hi[i], kind);
        met[i] = plt_four_meet(&four, &planes, kind, &enter[i]) & at->lanes;
    }
    const unsigned first = first_is_farther(p, lo, hi) ^ p->any;
    format_child(&c, first, &one->place);
    format_child(&c, first ^ 1, &two->place);
    one->enter = enter[first];
    two->enter = enter[first ^ 1];
    one->hull = two->hull = at->hull;
    one->lanes = (uint8_t)met[first];
    two->lanes = (uint8_t)met[first ^ 1];
}

/* Visits the node that `at` leads to. Leaves that are met go into the queue; of inner children
 * the first is the new `at`, the other waits. 0: there is none. Entries are written before it is
 * known whether they count: there is room, and no jump. */
PLT_INLINED int visit_hulls(plt_traversal *t, const plt_packet *p, hulls_entry *at,
                            enum plt_coherence kind) {
    hulls_entry one, two;
    meet_children(t, p, at, kind, &one, &two);
    t->stats.group_tests += 2;
    t->stats.node_visits++;
    const unsigned one_met = one.lanes != 0, two_met = two.lanes != 0;
    const unsigned one_leaf = one_met & (unsigned)format_is_leaf(&one.place);
    const unsigned two_leaf = two_met & (unsigned)format_is_leaf(&two.place);
    const unsigned goes = one_met & ~one_leaf, waits = two_met & ~two_leaf;
    hulls_entry *queue = (hulls_entry *)t->leaves + t->leaves_waiting;
    queue[0] = one;
    queue[one_leaf] = two;
    t->leaves_waiting += one_leaf + two_leaf;
    if (goes) {
        ((hulls_entry *)t->stack)[t->waiting] = two;
        t->waiting += waits;
        *at = one;
        return 1;
    }
    *at = two;
    return (int)waits;
}

/* From an entry down until no inner node is met. Adds the nodes visited to `visits`. */
PLT_INLINED int descend_hulls(plt_traversal *t, plt_packet *p, hulls_entry *at, uint32_t *visits,
                              enum plt_coherence kind) {
    if (format_is_leaf(&at->place)) { /* of a tree that is one leaf */
        ((hulls_entry *)t->leaves)[t->leaves_waiting++] = *at;
        return PLT_OK;
    }
    for (;;) {
        if (at->hull < p->first_group && !refine(t, p, at, kind)) {
            break;
        }
        if (hulls_wait(t, at)) {
            break;
        }
        const int crossed = format_cross(t, &at->place);
        if (crossed != PLT_OK) {
            return crossed;
        }
        ++*visits;
        if (!visit_hulls(t, p, at, kind)) {
            break;
        }
        if ((int)t->leaves_waiting >= HULLS_LEAVES) {
            const int status = test_leaves(t, p, kind);
            if (status != PLT_OK || p->active == 0) {
                return status;
            }
        }
    }
    return PLT_OK;
}

PLT_INLINED int pop_kind(plt_traversal *t, plt_packet *p, uint32_t *visits,
                         enum plt_coherence kind) {
    hulls_entry at = ((hulls_entry *)t->stack)[--t->waiting];
    int status = PLT_OK;
    at.lanes = (uint8_t)still_open(p, &at);
    const int goes_on = at.lanes != 0 && !hulls_wait(t, &at);
    if (goes_on) {
        status = format_return(t, &at.place);
    }
    if (goes_on && status == PLT_OK) {
        status = descend_hulls(t, p, &at, visits, kind);
    }
    if (status == PLT_OK && ((int)t->leaves_waiting >= HULLS_LEAVES || t->waiting == 0)) {
        status = test_leaves(t, p, kind);
    }
    return status;
}

static int pop_hulls(plt_traversal *t, plt_packet *p, uint32_t *visits) {
    switch (p->slabs.coherence) {
    case PLT_ONE_ORIGIN:
        return pop_kind(t, p, visits, PLT_ONE_ORIGIN);
    case PLT_ONE_SIGN:
        return pop_kind(t, p, visits, PLT_ONE_SIGN);
    default:
        return pop_kind(t, p, visits, PLT_MIXED);
    }
}

static int push_root_hulls(plt_traversal *t, plt_packet *p) {
    hulls_entry *root = (hulls_entry *)t->stack;
    root->hull = 0;
    root->lanes = 15;
    root->enter = f4_zero();
    t->leaves_waiting = 0;
    if (p->first_group == 0) {
        plt_group_make_ready(p, 0);
    }
    return format_root(t, &root->place);
}

#if FORMAT_MEETS
/* Where all packets meet first, be it an edge or not. */
static int root_waits_hulls(plt_traversal *t) {
    const hulls_entry *root = (const hulls_entry *)t->stack;
    return format_wait(t, &root->place, 0.0f, root, sizeof *root);
}

/* What waits at an edge, the entry on the stack, is not hidden by hits found meanwhile. */
static inline int is_open_hulls(const plt_traversal *t, const plt_packet *p) {
    return p->active != 0 && still_open(p, (const hulls_entry *)t->stack) != 0;
}
#endif

#endif

#endif
