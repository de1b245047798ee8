/* order_depth_first - one stack over the whole tree
 *
 * The nearer child is visited at once, the farther one waits. An entry's groups are
 * tested against its box when it is pushed and again when it is popped, since hits
 * found meanwhile count; distances are never stored.
 *
 * Include a format (format.h) before this file.
 *
 * Source: Karrenberg 2007, sections 3.5.2 and 3.5.4.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_ORDER_DEPTH_FIRST_H
#define PLT_TRACE_ORDER_DEPTH_FIRST_H

#include "engine/trace/boxes.h"

/* Visits the node that `at` leads to, and goes on to the nearer child that is met; the
 * other one, if it is met, too, waits. 0: none is. Outlined, or both children's
 * boxes would lie on the stack below every leaf. */
PLT_OUTLINED static int visit_node(plt_traversal *t, const plt_packet *p, format_entry *at) {
    format_children c;
    plt_mask hit[2];
    format_decode(t, at, &c);
    const plt_box *box = format_boxes(&c);
    t->stats.group_tests += 2 * plt_box_pair(&p->slabs, box, at->groups, hit);
    t->stats.node_visits++;
    unsigned near = plt_nearer_child(p, box);
    if (hit[near] == 0) {
        near ^= 1;
    } else if (hit[near ^ 1] != 0) {
        format_child(&c, near ^ 1, hit[near ^ 1], (format_entry *)t->stack + t->waiting++);
    }
    if (hit[near] == 0) {
        return 0;
    }
    format_child(&c, near, hit[near], at);
    return 1;
}

/* From an entry down to a leaf, or to nothing. `visits` counts nodes. */
static int descend(plt_traversal *t, plt_packet *p, format_entry *at, uint32_t *visits) {
    while (!format_is_leaf(at)) {
        ++*visits;
        if (!visit_node(t, p, at)) {
            return PLT_OK;
        }
        if (!format_is_leaf(at) && format_is_edge(at)) {
            const int status = format_enter(t, p, at);
            if (status != PLT_OK || at->groups == 0) {
                return status;
            }
        }
    }
    return format_leaf(t, p, at);
}

static int traverse_depth_first(plt_traversal *t, plt_packet *p, uint32_t visits) {
    while (t->waiting > 0 && visits > 0) {
        format_entry at = ((format_entry *)t->stack)[--t->waiting];
        uint32_t used = 1;
        at.groups &= p->active;
        int status = format_resume(t, p, &at);
        if (status == PLT_OK && at.groups != 0) {
            status = descend(t, p, &at, &used);
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
