/* walk_depth_first - one stack over the whole tree, for resident scenes
 *
 * The nearer child is gone into at once, the other one waits. An entry is a
 * node of a treelet (its index says which) or a leaf.
 *
 * Source: Karrenberg 2007, sections 3.5.2 and 3.5.4.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/boxes.h"
#include "engine/trace/walk.h"

/* From a node down to a leaf that is hit, or to nothing; the far children
 * wait on the stack. Returns the visits. */
static uint32_t descend(plt_walker *w, plt_entry *at) {
    uint32_t visits = 0;
    while (!plt_link_is_leaf(at->link)) {
        const plt_node *node;
        plt_box child[2];
        plt_mask hit[2];
        if (visits == 0 || !plt_link_is_inner(at->link)) {
            plt_walk_enter(w, plt_link_index(at->link));
        }
        int near = plt_walk_visit(w, at, &node, child, hit);
        visits++;
        if (hit[near] == 0) {
            near ^= 1;
        } else if (hit[near ^ 1] != 0) {
            plt_entry *far = &w->stack[w->waiting++];
            far->box = child[near ^ 1];
            far->link = plt_node_link(node, near ^ 1);
            far->groups = hit[near ^ 1];
        }
        if (hit[near] == 0) {
            return visits;
        }
        at->box = child[near];
        at->link = plt_node_link(node, near);
        at->groups = hit[near];
    }
    plt_walk_leaf(w, at);
    return visits;
}

uint32_t plt_walk_depth_first(plt_walker *w, uint32_t visits) {
    while (w->waiting > 0 && visits > 0) {
        plt_entry at = w->stack[--w->waiting];
        at.groups = plt_box_groups(&w->packet, at.box.lo, at.box.hi, at.groups & w->packet.active);
        const uint32_t used = at.groups == 0 ? 1 : 1 + descend(w, &at);
        visits -= used < visits ? used : visits;
        if (w->packet.active == 0) {
            w->waiting = 0;
        }
    }
    return visits;
}
