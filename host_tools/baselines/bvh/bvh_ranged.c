/* bvh_ranged - see bvh_ranged.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/bvh/bvh_ranged.h"

#include "host_tools/baselines/packet/packet_triangles.h"

typedef struct range_entry {
    uint32_t node;
    packet_range rays;
} range_entry;

typedef struct bits_entry {
    uint32_t node;
    packet_mask rays;
} bits_entry;

static inline uint32_t near_child(const packet_state *p, const binary_node *n) {
    return n->first + packet_is_backwards(p, n->axis);
}

static inline uint32_t far_child(const packet_state *p, const binary_node *n) {
    return n->first + 1 - packet_is_backwards(p, n->axis);
}

static inline void meet_leaf(const binary_tree *t, packet_state *p, const binary_node *n,
                             plt_mask groups, uint32_t active) {
    packet_meet_triangles(p, &t->record[n->first], plt_box_longest_side(&n->box), groups, active);
}

/* ---- from the first group to the last ----------------------------------------------- */

/* 1: goes on into an inner node, whose box the packet meets. */
PLT_INLINED int visit_range(const binary_tree *t, packet_state *p, range_entry *at,
                            enum plt_coherence kind, packet_steps steps) {
    const binary_node *n = &t->node[at->node];
    const f4 lo = packet_box_lo(&n->box), hi = packet_box_hi(&n->box);
    packet_count_node(&p->counts, p->count, packet_range_rays(p, &at->rays));
    if (!packet_meet_range(p, lo, hi, kind, steps, &at->rays)) {
        return 0;
    }
    if (!binary_is_leaf(n)) {
        return 1;
    }
    const plt_mask groups = packet_groups_in(p, lo, hi, kind, &at->rays);
    meet_leaf(t, p, n, groups, packet_rays_of(p, groups));
    return 0;
}

PLT_INLINED void trace_range(const binary_tree *t, packet_state *p, enum plt_coherence kind,
                             packet_steps steps) {
    range_entry stack[BINARY_DEPTH], at = {0, p->whole};
    unsigned waiting = 0;
    for (;;) {
        if (visit_range(t, p, &at, kind, steps)) {
            const binary_node *n = &t->node[at.node];
            stack[waiting++] = (range_entry){far_child(p, n), at.rays};
            at.node = near_child(p, n);
        } else if (waiting == 0 || packet_is_done(p)) {
            return;
        } else {
            at = stack[--waiting];
        }
    }
}

void bvh_trace_range(const binary_tree *t, packet_state *p, packet_steps steps) {
    switch (p->rays.slabs.coherence) {
    case PLT_ONE_ORIGIN:
        trace_range(t, p, PLT_ONE_ORIGIN, steps);
        break;
    case PLT_ONE_SIGN:
        trace_range(t, p, PLT_ONE_SIGN, steps);
        break;
    default:
        trace_range(t, p, PLT_MIXED, steps);
        break;
    }
}

/* ---- active rays alone ---------------------------------------------------------------- */

/* 1: likewise; `at` has the rays that go on. */
PLT_INLINED int visit_bits(const binary_tree *t, packet_state *p, bits_entry *at,
                           enum plt_coherence kind, packet_steps steps) {
    const binary_node *n = &t->node[at->node];
    const int is_leaf = binary_is_leaf(n);
    const packet_steps how = {(uint8_t)(steps.early && !is_leaf), steps.frustum};
    const packet_mask in = at->rays;
    packet_count_node(&p->counts, p->count, packet_mask_count(&in));
    if (!packet_meet_bits(p, packet_box_lo(&n->box), packet_box_hi(&n->box), kind, how, &in,
                          &at->rays)) {
        return 0;
    }
    if (is_leaf) {
        meet_leaf(t, p, n, packet_mask_groups(&at->rays), packet_mask_count(&at->rays));
    }
    return !is_leaf;
}

PLT_INLINED void trace_bits(const binary_tree *t, packet_state *p, enum plt_coherence kind,
                            packet_steps steps) {
    bits_entry stack[BINARY_DEPTH], at = {.node = 0};
    unsigned waiting = 0;
    packet_all(p, &at.rays);
    for (;;) {
        if (visit_bits(t, p, &at, kind, steps)) {
            const binary_node *n = &t->node[at.node];
            stack[waiting++] = (bits_entry){far_child(p, n), at.rays};
            at.node = near_child(p, n);
        } else if (waiting == 0 || packet_is_done(p)) {
            return;
        } else {
            at = stack[--waiting];
        }
    }
}

void bvh_trace_bits(const binary_tree *t, packet_state *p, packet_steps steps) {
    switch (p->rays.slabs.coherence) {
    case PLT_ONE_ORIGIN:
        trace_bits(t, p, PLT_ONE_ORIGIN, steps);
        break;
    case PLT_ONE_SIGN:
        trace_bits(t, p, PLT_ONE_SIGN, steps);
        break;
    default:
        trace_bits(t, p, PLT_MIXED, steps);
        break;
    }
}
