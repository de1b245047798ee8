/* walk - what both orders of traversal share; see walk.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/walk.h"

#include "engine/trace/boxes.h"
#include "engine/trace/triangle.h"

void plt_walk_begin(plt_walker *w) {
    if (w->compact) {
        plt_walk_blocks_begin(w);
    } else {
        const plt_entry root = {w->tree.box, w->tree.root, 0.0f, w->packet.active};
        w->stack[0] = root;
        w->waiting = w->packet.active != 0 && w->tree.root != PLT_LINK_NONE;
        w->block = PLT_MISS;
    }
    w->stats.packets++;
    w->stats.mixed_packets += w->packet.mixed;
}

int plt_walk_nearer(const plt_packet *p, const float *const lo[2], const float *const hi[2]) {
    float ahead = 0.0f;
    for (int a = 0; a < 3; a++) {
        const float left = lo[0][a] + hi[0][a];
        const float right = lo[1][a] + hi[1][a];
        ahead += p->forward[a] * (left - right);
    }
    return ahead > 0.0f;
}

/* Both children are asked for before it is known which are hit: a line too
 * many costs less than one that is late. */
static void prefetch_child(const plt_tree *tree, uint32_t link) {
    if (plt_link_is_leaf(link)) {
        plt_prefetch(&tree->records[plt_link_index(link)]);
    } else {
        plt_prefetch(&tree->nodes[plt_link_index(link)]);
    }
}

int plt_walk_visit(plt_walker *w, const plt_entry *at, const plt_node **node, plt_box child[2],
                   plt_mask hit[2]) {
    *node = &w->tree.nodes[plt_link_index(at->link)];
    prefetch_child(&w->tree, plt_node_link(*node, 0));
    prefetch_child(&w->tree, plt_node_link(*node, 1));
    plt_node_decode(*node, &at->box, child);
    const float *const lo[2] = {child[0].lo, child[1].lo}, *const hi[2] = {child[0].hi,
                                                                           child[1].hi};
    plt_box_pair(&w->packet, lo, hi, at->groups, hit);
    w->stats.node_visits++;
    w->stats.group_tests += 2 * plt_mask_count(at->groups);
    return plt_walk_nearer(&w->packet, lo, hi);
}

void plt_walk_leaf(plt_walker *w, const plt_entry *at) {
    uint32_t number = plt_link_index(at->link);
    plt_mask groups = at->groups;
    const uint32_t in_hand = plt_mask_count(groups);
    plt_triangle triangle;
    triangle.longest = plt_box_longest_side(&at->box);
    triangle.numbers = NULL;
    for (uint32_t lists = plt_link_lists(at->link); lists > 0; number++) {
        const plt_record *record = &w->tree.records[number];
        plt_record_corners(record, triangle.corner);
        triangle.number = plt_get_u32(&record->word[9]);
        if (w->packet.any) {
            groups &= w->packet.active;
        }
        plt_triangle_groups(&w->packet, &triangle, groups);
        w->stats.triangle_tests += in_hand;
        lists -= (uint32_t)plt_record_is_last(record);
    }
}

void plt_walk_enter(plt_walker *w, uint32_t index) {
    const uint32_t block = index / w->tree.treelet_nodes;
    if (block == w->block) {
        return;
    }
    const uint32_t bytes = w->tree.treelet_nodes * PLT_NODE_BYTES;
    w->block = block;
    w->stats.treelet_fetches++;
    w->stats.bytes_fetched += bytes;
    if (!(w->touched[block / 32] >> block % 32 & 1u)) {
        w->touched[block / 32] |= 1u << block % 32;
        w->stats.bytes_touched_once += bytes;
    }
}
