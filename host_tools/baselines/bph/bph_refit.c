/* bph_refit - see bph_refit.h
 *
 * Nodes lie depth first, children behind their parents: one pass from the first on reconstructs
 * the old boxes, one back from the last fits the new ones.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/bph/bph_refit.h"

#include <string.h>

#include "host_tools/base/heap.h"

/* Of a node: its children's boxes as they were, its own as it is. */
typedef struct boxes {
    plt_box old[2], now;
} boxes;

static void reconstruct(const bph_tree *t, boxes *of) {
    for (uint32_t i = 0; i < t->nodes; i++) {
        const plt_box mine = i == 0 ? t->box : of[i].now;
        plt_node_decode(&t->node[i], &mine, of[i].old);
        for (int c = 0; c < 2; c++) {
            const uint32_t link = plt_node_link(&t->node[i], c);
            if (!plt_link_is_leaf(link)) {
                of[plt_link_index(link)].now = of[i].old[c]; /* until it is fitted */
            }
        }
    }
}

static plt_box child_box(const bph_tree *t, const boxes *of, uint32_t node, int child) {
    const bph_edge e = bph_tree_edge(t, node, child);
    return plt_link_is_leaf(e.link)
               ? plt_records_box(t->record, plt_link_index(e.link), bph_edge_end(t, &e))
               : of[plt_link_index(e.link)].now;
}

/* 1: the node was left as it was. */
static uint32_t fit(bph_tree *t, boxes *of, uint32_t node) {
    plt_node *n = &t->node[node];
    const plt_box box[2] = {child_box(t, of, node, 0), child_box(t, of, node, 1)};
    of[node].now = box[0];
    plt_box_add(&of[node].now, &box[1]);
    if (memcmp(box, of[node].old, sizeof box) == 0) {
        return 1;
    }
    const uint32_t link[2] = {plt_node_link(n, 0), plt_node_link(n, 1)};
    plt_node_encode(n, &of[node].now, box);
    plt_node_relink(n, 0, link[0]);
    plt_node_relink(n, 1, link[1]);
    return 0;
}

uint32_t bph_refit(bph_tree *t) {
    boxes *of = heap_get((uint64_t)t->nodes * sizeof *of + 1);
    uint32_t same = 0;
    if (of == NULL) {
        return BPH_REFIT_NO_MEMORY;
    }
    reconstruct(t, of);
    for (uint32_t i = t->nodes; i-- > 0;) {
        same += fit(t, of, i);
    }
    t->box = t->nodes > 0 ? of[0].now : plt_records_box(t->record, 0, t->records);
    heap_drop(of);
    return same;
}
