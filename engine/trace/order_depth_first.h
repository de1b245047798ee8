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

#include "engine/base/small_stack.h"
#include "engine/trace/boxes.h"
#include "engine/trace/format_meets.h"

typedef struct depth_first_entry {
    format_place place;
    plt_mask groups;
} depth_first_entry;

#if FORMAT_MEETS
/* From where a ray of the packet begins to the entry's box, squared. */
PLT_APART_ON_SMALL_STACKS static float distance_to(const plt_traversal *t, const plt_packet *p,
                                                   const depth_first_entry *e) {
    format_room room;
    const plt_box *box = format_box(t, &e->place, &room);
    const plt_group_rays *g = &p->rays[plt_mask_first(e->groups)];
    float square = 0.0f;
    for (int a = 0; a < 3; a++) {
        const float from = g->org[a][0];
        const float above = box->lo[a] - from, below = from - box->hi[a];
        const float side = above > below ? above : below;
        square += side > 0.0f ? side * side : 0.0f;
    }
    return square;
}
#endif

/* The entry waits at its edge for other packets (format_meets.h). 0: it is to go on. */
static inline int depth_first_waits(plt_traversal *t, const plt_packet *p,
                                    const depth_first_entry *e) {
#if FORMAT_MEETS
    return plt_meets(t) && e->groups != 0 && !format_is_leaf(&e->place) &&
           format_is_edge(&e->place) &&
           format_wait(t, &e->place, distance_to(t, p, e), e, sizeof *e);
#else
    (void)t;
    (void)p;
    (void)e;
    return 0;
#endif
}

/* Groups of the entry that meet its box. */
PLT_APART_ON_SMALL_STACKS static plt_mask meet(const plt_traversal *t, const plt_packet *p,
                                               const depth_first_entry *e) {
    format_room room;
    return plt_box_groups(&p->slabs, format_box(t, &e->place, &room), e->groups);
}

/* Visits the node that `at` leads to, and goes on to the nearer child that is met; the
 * other one, if it is met, too, waits. 0: none is. Apart, or both children's boxes would
 * lie on the stack below every leaf. */
PLT_APART_ON_SMALL_STACKS static int visit_node(plt_traversal *t, const plt_packet *p,
                                                depth_first_entry *at) {
    format_children c;
    plt_mask hit[2];
    format_decode(t, &at->place, &c);
    const plt_box *box = format_boxes(&c);
    t->stats.group_tests += 2 * plt_box_pair(&p->slabs, box, at->groups, hit);
    t->stats.node_visits++;
    unsigned near = plt_nearer_child(p, box);
    if (hit[near] == 0) {
        near ^= 1;
    } else if (hit[near ^ 1] != 0) {
        depth_first_entry *far = (depth_first_entry *)t->stack + t->waiting++;
        format_child(&c, near ^ 1, &far->place);
        far->groups = hit[near ^ 1];
    }
    if (hit[near] == 0) {
        return 0;
    }
    format_child(&c, near, &at->place);
    at->groups = hit[near];
    return 1;
}

/* The box that leads over an edge has just been tested. Testing tighter bounds behind it
 * pays only when a single group is left. */
static inline int cross_edge(plt_traversal *t, const plt_packet *p, depth_first_entry *at) {
    const int status = format_enter(t, &at->place);
    if (FORMAT_TIGHTENS && status == PLT_OK && (at->groups & (at->groups - 1)) == 0) {
        at->groups = meet(t, p, at);
    }
    return status;
}

/* From an entry down to a leaf, or to nothing. Adds the nodes visited to `visits`. */
static int descend(plt_traversal *t, plt_packet *p, depth_first_entry *at, uint32_t *visits) {
    while (!format_is_leaf(&at->place)) {
        ++*visits;
        if (!visit_node(t, p, at)) {
            return PLT_OK;
        }
        if (!format_is_leaf(&at->place) && format_is_edge(&at->place)) {
            if (depth_first_waits(t, p, at)) {
                return PLT_OK;
            }
            const int status = cross_edge(t, p, at);
            if (status != PLT_OK || at->groups == 0) {
                return status;
            }
        }
    }
    return format_leaf(t, p, &at->place, at->groups);
}

/* An entry that has waited: hits found meanwhile may hide its box. Where the bounds behind
 * an edge are tighter they are tested instead. */
static inline int resume(plt_traversal *t, const plt_packet *p, depth_first_entry *at) {
    const int crosses =
        FORMAT_TIGHTENS && !format_is_leaf(&at->place) && format_is_edge(&at->place);
#if FORMAT_MEETS
    if (plt_meets(t) && crosses) { /* what has waited long is hidden often */
        at->groups = meet(t, p, at);
    }
#endif
    if (crosses && at->groups != 0) {
        const int status = format_enter(t, &at->place);
        if (status != PLT_OK) {
            return status;
        }
    }
    at->groups = at->groups != 0 ? meet(t, p, at) : 0;
    return at->groups == 0 || crosses ? PLT_OK : format_return(t, &at->place);
}

static int pop_depth_first(plt_traversal *t, plt_packet *p, uint32_t *visits) {
    depth_first_entry at = ((depth_first_entry *)t->stack)[--t->waiting];
    at.groups &= p->active;
    if (depth_first_waits(t, p, &at)) {
        return PLT_OK;
    }
    const int status = resume(t, p, &at);
    return status != PLT_OK || at.groups == 0 ? status : descend(t, p, &at, visits);
}

static int push_root_depth_first(plt_traversal *t, const plt_packet *p) {
    depth_first_entry *root = (depth_first_entry *)t->stack;
    root->groups = p->active;
    return format_root(t, &root->place);
}

#if FORMAT_MEETS
/* Where all packets meet first, be it an edge or not. */
static int root_waits_depth_first(plt_traversal *t) {
    const depth_first_entry *root = (const depth_first_entry *)t->stack;
    return format_wait(t, &root->place, 0.0f, root, sizeof *root);
}

/* What waits at an edge, the entry on the stack, is not hidden by hits found meanwhile. */
static inline int is_open_depth_first(const plt_traversal *t, const plt_packet *p) {
    depth_first_entry e = *(const depth_first_entry *)t->stack;
    e.groups &= p->active;
    return e.groups != 0 && meet(t, p, &e) != 0;
}
#endif

#endif
