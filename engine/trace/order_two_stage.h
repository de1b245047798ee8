/* order_two_stage - the thesis's traversal of treelets
 *
 * The global stack holds edges that leave treelets, and leaves. The local stage visits
 * the treelet behind an edge to the end; the edges that leave it are then sorted,
 * nearest on top. (The thesis takes them as they come, which is far first: sections
 * 4.2 and 8.2.4.)
 *
 * Include a format (format.h) with distances before this file.
 *
 * Source: Karrenberg 2007, section 4.2 and figure 4.2.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_ORDER_TWO_STAGE_H
#define PLT_TRACE_ORDER_TWO_STAGE_H

#include "engine/trace/boxes.h"

/* Descending by distance: Shell's sort, which needs nothing but the entries. */
static void sort_edges(format_entry *edge, uint32_t count) {
    uint32_t gap = 1;
    while (gap < count / 3) {
        gap = 3 * gap + 1;
    }
    for (; gap > 0; gap /= 3) {
        for (uint32_t i = gap; i < count; i++) {
            const format_entry moved = edge[i];
            uint32_t k = i;
            for (; k >= gap && edge[k - gap].distance < moved.distance; k -= gap) {
                edge[k] = edge[k - gap];
            }
            edge[k] = moved;
        }
    }
}

static void push_edge(plt_traversal *t, const plt_packet *p, const format_entry *e) {
    format_entry *top = (format_entry *)t->stack + t->waiting++;
    *top = *e;
    top->distance = plt_box_entry(&p->slabs, format_box(e), e->groups);
}

/* Children that are met: the nearer inner one becomes `at`, a farther one waits on the
 * local stack, edges and leaves go onto the global one. 0: no inner one is met. */
static int visit_local(plt_traversal *t, const plt_packet *p, format_entry *at, uint32_t *waiting) {
    format_children c;
    plt_mask hit[2];
    int goes_on = 0;
    format_decode(t, at, &c);
    const plt_box *box = format_boxes(&c);
    t->stats.group_tests += 2 * plt_box_pair(&p->slabs, box, at->groups, hit);
    t->stats.node_visits++;
    const unsigned near = plt_nearer_child(p, box);
    for (unsigned k = 0; k < 2; k++) {
        format_entry e;
        if (hit[near ^ k] == 0) {
            continue;
        }
        format_child(&c, near ^ k, hit[near ^ k], &e);
        if (format_is_leaf(&e) || format_is_edge(&e)) {
            push_edge(t, p, &e);
        } else if (!goes_on) {
            *at = e;
            goes_on = 1;
        } else {
            ((format_entry *)t->local)[(*waiting)++] = e;
        }
    }
    return goes_on;
}

/* The treelet in hand from its root `at`. Returns the visits. */
static uint32_t visit_treelet(plt_traversal *t, const plt_packet *p, format_entry *at) {
    const uint32_t first_edge = t->waiting;
    uint32_t waiting = 0, visits = 1;
    for (;; visits++) {
        if (visit_local(t, p, at, &waiting)) {
            continue;
        }
        if (waiting == 0) {
            break;
        }
        *at = ((format_entry *)t->local)[--waiting];
    }
    sort_edges((format_entry *)t->stack + first_edge, t->waiting - first_edge);
    return visits;
}

static int traverse_two_stage(plt_traversal *t, plt_packet *p, uint32_t visits) {
    while (t->waiting > 0 && visits > 0) {
        format_entry at = ((format_entry *)t->stack)[--t->waiting];
        uint32_t used = 1;
        at.groups &= p->active;
        int status = format_resume(t, p, &at);
        if (status == PLT_OK && at.groups != 0) {
            if (format_is_leaf(&at)) {
                status = format_leaf(t, p, &at);
            } else {
                used += visit_treelet(t, p, &at);
            }
        }
        if (status != PLT_OK) {
            t->waiting = 0;
            return status;
        }
        visits -= used < visits ? used : visits;
        if (p->active == 0) {
            t->waiting = 0;
        }
    }
    return t->waiting > 0 ? PLT_MORE : PLT_OK;
}

#endif
