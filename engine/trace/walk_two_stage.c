/* walk_two_stage - the thesis's traversal of treelets
 *
 * The global stack holds edges that leave treelets, and leaves. Taking an edge
 * off it, the local stage visits one treelet to the end; the edges that leave
 * it are then put into order, nearest on top. (The thesis takes them in the
 * order they come, which is far first: sections 4.2 and 8.2.4.)
 *
 * Source: Karrenberg 2007, section 4.2 and figure 4.2.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/boxes.h"
#include "engine/trace/walk.h"

/* Descending by distance: Shell's sort, which needs nothing but the entries. */
static void sort_edges(plt_entry *edge, uint32_t count) {
    uint32_t gap = 1;
    while (gap < count / 3) {
        gap = 3 * gap + 1;
    }
    for (; gap > 0; gap /= 3) {
        for (uint32_t i = gap; i < count; i++) {
            const plt_entry moved = edge[i];
            uint32_t k = i;
            for (; k >= gap && edge[k - gap].entry < moved.entry; k -= gap) {
                edge[k] = edge[k - gap];
            }
            edge[k] = moved;
        }
    }
}

static void push_edge(plt_walker *w, const plt_box *box, uint32_t link, plt_mask groups) {
    const plt_entry edge = {*box, link, plt_box_entry(&w->packet, box, groups), groups};
    w->stack[w->waiting++] = edge;
}

/* One path down inside the treelet; far inner children wait on the local
 * stack, edges go onto the global one. Returns the visits. */
static uint32_t descend_locally(plt_walker *w, plt_entry *at, uint32_t *waiting) {
    for (uint32_t visits = 1;; visits++) {
        const plt_node *node;
        plt_box child[2];
        plt_mask hit[2];
        const int near = plt_walk_visit(w, at, &node, child, hit);
        int inner = -1; /* the child to go into */
        for (int k = 0; k < 2; k++) {
            const int c = near ^ k;
            const uint32_t link = plt_node_link(node, c);
            if (hit[c] == 0) {
                continue;
            }
            if (!plt_link_is_inner(link)) {
                push_edge(w, &child[c], link, hit[c]);
            } else if (inner < 0) {
                inner = c;
            } else {
                const plt_entry far = {child[c], link, 0.0f, hit[c]};
                w->local[(*waiting)++] = far;
            }
        }
        if (inner < 0) {
            return visits;
        }
        at->box = child[inner];
        at->link = plt_node_link(node, inner);
        at->groups = hit[inner];
    }
}

static uint32_t visit_treelet(plt_walker *w, plt_entry *at) {
    const uint32_t first_edge = w->waiting;
    uint32_t waiting = 0;
    plt_walk_enter(w, plt_link_index(at->link));
    uint32_t visits = descend_locally(w, at, &waiting);
    while (waiting > 0) {
        plt_entry next = w->local[--waiting];
        visits += descend_locally(w, &next, &waiting);
    }
    sort_edges(w->stack + first_edge, w->waiting - first_edge);
    return visits;
}

uint32_t plt_walk_two_stage(plt_walker *w, uint32_t visits) {
    while (w->waiting > 0 && visits > 0) {
        plt_entry at = w->stack[--w->waiting];
        uint32_t used = 1;
        at.groups = plt_box_groups(&w->packet, at.box.lo, at.box.hi, at.groups & w->packet.active);
        if (at.groups != 0 && plt_link_is_leaf(at.link)) {
            plt_walk_leaf(w, &at);
        } else if (at.groups != 0) {
            used += visit_treelet(w, &at);
        }
        visits -= used < visits ? used : visits;
        if (w->packet.active == 0) {
            w->waiting = 0;
        }
    }
    return visits;
}
