/* bvh_pair - see bvh_pair.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/bvh/bvh_pair.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/packet/packet_triangles.h"

void bvh_pair_free(bvh_pair_tree *t) {
    heap_drop(t->node);
    memset(t, 0, sizeof *t);
}

/* ---- from a binary tree --------------------------------------------------------------- */

/* A node of the binary tree that a link leads to. */
typedef struct waiting_node {
    uint32_t from;       /* of the binary tree */
    uint32_t node, side; /* of the link; the root's has no node */
} waiting_node;

enum { ROOT = 0xFFFFFFFFu };

static bvh_pair_link list_of(bvh_pair_tree *t, const binary_node *leaf) {
    t->lists++;
    return (bvh_pair_link){leaf->first, leaf->count, 0};
}

/* Both lists lie in a row, whichever comes first. */
static bvh_pair_link joined_list(bvh_pair_tree *t, const binary_tree *from,
                                 const binary_node child[2]) {
    const int second = child[1].first < child[0].first;
    const uint32_t first = child[second].first, middle = first + child[second].count;
    t->lists++;
    t->intermediates++;
    plt_record_set_last(&from->record[middle - 1], 0);
    return (bvh_pair_link){first, (uint16_t)(child[0].count + child[1].count), 0};
}

static bvh_pair_link link_of(bvh_pair_tree *t, const binary_tree *from, uint32_t at) {
    const binary_node *n = &from->node[at], *child = &from->node[n->first];
    if (binary_is_leaf(n)) {
        return list_of(t, n);
    }
    if (binary_is_leaf(&child[0]) && binary_is_leaf(&child[1])) {
        return joined_list(t, from, child);
    }
    return (bvh_pair_link){t->nodes++, 0, n->axis};
}

static void set_link(bvh_pair_tree *t, const waiting_node *w, bvh_pair_link link) {
    if (w->node == (uint32_t)ROOT) {
        t->root = link;
    } else {
        t->node[w->node].child[w->side] = link;
    }
}

static void fill(bvh_pair_tree *t, const binary_tree *from) {
    waiting_node stack[BINARY_DEPTH];
    unsigned waiting = 0;
    stack[waiting++] = (waiting_node){0, (uint32_t)ROOT, 0};
    while (waiting > 0) {
        const waiting_node w = stack[--waiting];
        const binary_node *n = &from->node[w.from];
        const bvh_pair_link link = link_of(t, from, w.from);
        set_link(t, &w, link);
        if (link.count > 0) {
            continue;
        }
        for (uint32_t side = 2; side-- > 0;) {
            t->node[link.first].box[side] = from->node[n->first + side].box;
            stack[waiting++] = (waiting_node){n->first + side, link.first, side};
        }
    }
}

int bvh_pair_make(bvh_pair_tree *t, const binary_tree *from) {
    if (from->leaves > t->room) {
        bvh_pair_free(t);
        t->node = heap_get_aligned((uint64_t)from->leaves * sizeof *t->node);
        if (t->node == NULL) {
            return -1;
        }
        t->room = from->leaves;
    }
    t->record = from->record;
    t->box = from->node[0].box;
    t->nodes = t->lists = t->intermediates = 0;
    fill(t, from);
    return 0;
}

/* ---- packets ---------------------------------------------------------------------------- */

typedef struct entry {
    bvh_pair_link link;
    packet_mask rays;
} entry;

static void meet_list(const bvh_pair_tree *t, packet_state *p, const entry *e, float longest) {
    packet_meet_triangles(p, &t->record[e->link.first], longest, packet_mask_groups(&e->rays),
                          packet_mask_count(&e->rays));
}

/* Both children against the packet; those that rays go on to, the nearer last. */
PLT_INLINED unsigned visit(const bvh_pair_tree *t, packet_state *p, const entry *at,
                           enum plt_coherence kind, packet_steps steps, entry to[2]) {
    const bvh_pair_node *n = &t->node[at->link.first];
    const unsigned near = packet_is_backwards(p, at->link.axis);
    unsigned met = 0;
    packet_count_node(&p->counts, p->count, packet_mask_count(&at->rays));
    for (unsigned i = 0; i < 2; i++) {
        const unsigned side = i == 0 ? near ^ 1u : near;
        const plt_box *b = &n->box[side];
        to[met].link = n->child[side];
        met += packet_meet_bits(p, packet_box_lo(b), packet_box_hi(b), kind, steps, &at->rays,
                                &to[met].rays) != 0;
    }
    return met;
}

PLT_INLINED void trace(const bvh_pair_tree *t, packet_state *p, enum plt_coherence kind,
                       packet_steps steps) {
    const float longest = plt_box_longest_side(&t->box);
    entry stack[2 * BINARY_DEPTH], *at = stack;
    at->link = t->root;
    packet_all(p, &at->rays);
    for (unsigned waiting = 1; waiting > 0 && !packet_is_done(p);) {
        const entry now = stack[--waiting];
        if (now.link.count > 0) {
            meet_list(t, p, &now, longest);
        } else {
            waiting += visit(t, p, &now, kind, steps, &stack[waiting]);
        }
    }
}

void bvh_pair_trace(const bvh_pair_tree *t, packet_state *p, packet_steps steps) {
    switch (p->rays.slabs.coherence) {
    case PLT_ONE_ORIGIN:
        trace(t, p, PLT_ONE_ORIGIN, steps);
        break;
    case PLT_ONE_SIGN:
        trace(t, p, PLT_ONE_SIGN, steps);
        break;
    default:
        trace(t, p, PLT_MIXED, steps);
        break;
    }
}
