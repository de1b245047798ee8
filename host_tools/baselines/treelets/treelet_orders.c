/* treelet_orders - see treelet_orders.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/treelets/treelet_orders.h"

#include "engine/trace/boxes.h"
#include "engine/trace/format.h"
#include "engine/tree/thesis/link.h"
#include "host_tools/baselines/packet/packet_box.h"
#include "host_tools/baselines/packet/packet_triangles.h"

void treelet_tracing_free(treelet_tracing *t) {
    treelet_stack_free(&t->global);
    treelet_stack_free(&t->local);
}

/* ---- entries ------------------------------------------------------------------------------ */

/* Rays of `in` that meet the box; 0: none. */
static int meet(const treelet_tracing *t, const plt_box *box, const packet_mask *in,
                packet_mask *out) {
    static const packet_steps every_ray = {0, 0};
    packet_state *p = t->packet;
    const f4 lo = packet_box_lo(box), hi = packet_box_hi(box);
    switch (p->rays.slabs.coherence) {
    case PLT_ONE_ORIGIN:
        return packet_meet_bits(p, lo, hi, PLT_ONE_ORIGIN, every_ray, in, out);
    case PLT_ONE_SIGN:
        return packet_meet_bits(p, lo, hi, PLT_ONE_SIGN, every_ray, in, out);
    default:
        return packet_meet_bits(p, lo, hi, PLT_MIXED, every_ray, in, out);
    }
}

/* Whether what comes off a stack goes on, and with which rays. */
static int goes_on(const treelet_tracing *t, treelet_entry *e) {
    const packet_mask before = e->rays;
    return !t->tests_again || meet(t, &e->box, &before, &e->rays);
}

/* The edge from a node in a treelet of that value leads to another treelet. */
static int leaves(const treelet_tracing *t, uint32_t link, unsigned parity) {
    const unsigned bit = (link & PLT_LINK_OUT) != 0;
    return t->nodes->edges == NODE_EDGES_DIRECT ? (int)bit : bit != parity;
}

/* The children of a node that rays go on to, in the order in which they are pushed. */
static unsigned visit(const treelet_tracing *t, const treelet_entry *at, treelet_entry to[2]) {
    packet_state *p = t->packet;
    treelet_child child[2];
    unsigned met = 0, first = 0;
    packet_count_node(&p->counts, p->count, packet_mask_count(&at->rays));
    t->nodes->children(t->nodes->self, plt_link_index(at->link), &at->box, child);
    if (t->order != TREELET_FIGURE) {
        const plt_box box[2] = {child[0].box, child[1].box};
        first = plt_nearer_child(&p->rays, box) ^ (t->order == TREELET_MIRRORED ? 0u : 1u);
    }
    for (unsigned k = 0; k < 2; k++) {
        const treelet_child *c = &child[first ^ k];
        treelet_entry *e = &to[met];
        e->box = c->box;
        e->link = c->link;
        e->parity = (uint8_t)((c->link & PLT_LINK_OUT) != 0);
        e->crosses = (uint8_t)(!plt_link_is_leaf(c->link) && leaves(t, c->link, at->parity));
        e->distance = 0.0f;
        if (!meet(t, &e->box, &at->rays, &e->rays)) {
            continue;
        }
        if (t->order != TREELET_DEPTH) {
            e->distance = plt_box_entry(&p->rays.slabs, &e->box, packet_mask_groups(&e->rays));
        }
        met++;
    }
    return met;
}

/* One list, or two in a row. */
static void meet_leaf(const treelet_tracing *t, const treelet_entry *e) {
    packet_state *p = t->packet;
    const plt_record *record = &t->nodes->record[plt_link_index(e->link)];
    const float longest = plt_box_longest_side(&t->nodes->box);
    const plt_mask groups = packet_mask_groups(&e->rays);
    const uint32_t active = packet_mask_count(&e->rays);
    packet_meet_triangles(p, record, longest, groups, active);
    if (plt_link_lists(e->link) == 2 && !packet_is_done(p)) {
        while (!plt_record_is_last(record++)) {
        }
        packet_meet_triangles(p, record, longest, groups, active);
    }
}

/* ---- two stages ----------------------------------------------------------------------------- */

static void push_edge(treelet_tracing *t, const treelet_entry *e) {
    if (t->order == TREELET_HEAP) {
        treelet_heap_push(&t->global, e);
    } else {
        treelet_push(&t->global, e);
    }
}

/* All of a treelet, from its root on. */
static void traverse_treelet(treelet_tracing *t, const treelet_entry *root) {
    const uint32_t first = t->global.count;
    treelet_push(&t->local, root);
    t->entered++;
    while (t->local.count > 0) {
        const treelet_entry at = treelet_pop(&t->local);
        treelet_entry to[2];
        const unsigned met = visit(t, &at, to);
        for (unsigned k = 0; k < met; k++) {
            if (plt_link_is_leaf(to[k].link) || to[k].crosses) {
                push_edge(t, &to[k]);
            } else {
                treelet_push(&t->local, &to[k]);
            }
        }
    }
    if (t->order == TREELET_SORTED || t->order == TREELET_LEAF_FIRST) {
        treelet_sort(&t->global, first, t->order == TREELET_LEAF_FIRST);
    }
}

static void two_stages(treelet_tracing *t) {
    while (t->global.count > 0 && !packet_is_done(t->packet)) {
        treelet_entry e =
            t->order == TREELET_HEAP ? treelet_heap_pop(&t->global) : treelet_pop(&t->global);
        if (!goes_on(t, &e)) {
            continue;
        }
        if (plt_link_is_leaf(e.link)) {
            meet_leaf(t, &e);
        } else {
            traverse_treelet(t, &e);
        }
    }
}

/* ---- depth first ----------------------------------------------------------------------------- */

static void depth_first(treelet_tracing *t) {
    while (t->global.count > 0 && !packet_is_done(t->packet)) {
        treelet_entry e = treelet_pop(&t->global), to[2];
        if (!goes_on(t, &e)) {
            continue;
        }
        if (plt_link_is_leaf(e.link)) {
            meet_leaf(t, &e);
            continue;
        }
        t->entered += e.crosses;
        const unsigned met = visit(t, &e, to);
        for (unsigned k = 0; k < met; k++) {
            treelet_push(&t->global, &to[k]);
        }
    }
}

int treelet_trace(treelet_tracing *t) {
    treelet_entry root = {.box = t->nodes->box, .link = t->nodes->root, .crosses = 1};
    t->global.count = t->local.count = 0;
    t->global.is_short = t->local.is_short = 0;
    if (t->nodes->root == PLT_LINK_NONE) {
        return 0;
    }
    packet_all(t->packet, &root.rays);
    treelet_push(&t->global, &root);
    if (t->order == TREELET_DEPTH) {
        depth_first(t);
    } else {
        two_stages(t);
    }
    return t->global.is_short || t->local.is_short ? -1 : 0;
}

int treelet_trace_packets(treelet_tracing *t, const plt_ray *rays, plt_hit *hits, uint32_t count,
                          int any) {
    const uint32_t most = t->packet->side * t->packet->side;
    for (uint32_t i = 0; i < count; i += most) {
        const uint32_t left = count - i, now = left < most ? left : most;
        if (packet_begin(t->packet, &t->nodes->box, rays + i, now, any) && treelet_trace(t) != 0) {
            return -1;
        }
        packet_store(t->packet, hits + i);
    }
    return 0;
}
