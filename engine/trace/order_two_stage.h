/* order_two_stage - the thesis's traversal of treelets
 *
 * The global stack holds edges that leave treelets, and leaves. The local stage visits
 * the treelet behind an edge to the end; the edges and leaves that it meets are then
 * sorted, nearest on top. (The thesis takes them as they come, which is far first:
 * sections 4.2 and 8.2.4.)
 *
 * Include a format (format.h) before this file.
 *
 * Source: Karrenberg 2007, section 4.2 and figure 4.2.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_ORDER_TWO_STAGE_H
#define PLT_TRACE_ORDER_TWO_STAGE_H

#include "engine/trace/boxes.h"

/* Of both stacks; only the global one has distances. */
typedef struct two_stage_entry {
    format_place place;
    float distance;
    plt_mask groups;
} two_stage_entry;

/* Descending by distance: Shell's sort, which needs nothing but the entries. */
static void sort_edges(two_stage_entry *edge, uint32_t count) {
    uint32_t gap = 1;
    while (gap < count / 3) {
        gap = 3 * gap + 1;
    }
    for (; gap > 0; gap /= 3) {
        for (uint32_t i = gap; i < count; i++) {
            const two_stage_entry moved = edge[i];
            uint32_t k = i;
            for (; k >= gap && edge[k - gap].distance < moved.distance; k -= gap) {
                edge[k] = edge[k - gap];
            }
            edge[k] = moved;
        }
    }
}

static void push_edge(plt_traversal *t, const plt_packet *p, const two_stage_entry *e) {
    two_stage_entry *top = (two_stage_entry *)t->stack + t->waiting++;
    format_room room;
    *top = *e;
    top->distance = plt_box_entry(&p->slabs, format_box(t, &e->place, &room), e->groups);
}

/* Children that are met: the nearer inner one becomes `at`, a farther one waits on the
 * local stack, edges and leaves go onto the global one. 0: no inner one is met. */
static int visit_local(plt_traversal *t, const plt_packet *p, two_stage_entry *at,
                       uint32_t *waiting) {
    format_children c;
    plt_mask hit[2];
    int goes_on = 0;
    format_decode(t, &at->place, &c);
    const plt_box *box = format_boxes(&c);
    t->stats.group_tests += 2 * plt_box_pair(&p->slabs, box, at->groups, hit);
    t->stats.node_visits++;
    const unsigned near = plt_nearer_child(p, box);
    for (unsigned k = 0; k < 2; k++) {
        two_stage_entry e;
        e.distance = 0.0f; /* until it is pushed */
        e.groups = hit[near ^ k];
        if (e.groups == 0) {
            continue;
        }
        format_child(&c, near ^ k, &e.place);
        if (format_is_leaf(&e.place) || format_is_edge(&e.place)) {
            push_edge(t, p, &e);
        } else if (!goes_on) {
            *at = e;
            goes_on = 1;
        } else {
            ((two_stage_entry *)t->local)[(*waiting)++] = e;
        }
    }
    return goes_on;
}

/* The current treelet from its root `at`. Returns the visits. */
static uint32_t visit_treelet(plt_traversal *t, const plt_packet *p, two_stage_entry *at) {
    const uint32_t first_edge = t->waiting;
    uint32_t waiting = 0, visits = 1;
    for (;; visits++) {
        if (visit_local(t, p, at, &waiting)) {
            continue;
        }
        if (waiting == 0) {
            break;
        }
        *at = ((two_stage_entry *)t->local)[--waiting];
    }
    sort_edges((two_stage_entry *)t->stack + first_edge, t->waiting - first_edge);
    return visits;
}

static int pop_two_stage(plt_traversal *t, plt_packet *p, uint32_t *visits) {
    two_stage_entry at = ((two_stage_entry *)t->stack)[--t->waiting];
    format_room room;
    at.groups = plt_box_groups(&p->slabs, format_box(t, &at.place, &room), at.groups & p->active);
    if (at.groups == 0) {
        return PLT_OK;
    }
    const int status = format_return(t, &at.place);
    if (status != PLT_OK) {
        return status;
    }
    if (format_is_leaf(&at.place)) {
        return format_leaf(t, p, &at.place, at.groups);
    }
    *visits += visit_treelet(t, p, &at);
    return PLT_OK;
}

static int push_root_two_stage(plt_traversal *t, const plt_packet *p) {
    two_stage_entry *root = (two_stage_entry *)t->stack;
    root->groups = p->active;
    root->distance = 0.0f;
    return format_root(t, &root->place);
}

#endif
