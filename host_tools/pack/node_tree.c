/* node_tree - see node_tree.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/node_tree.h"

#include <string.h>

#include "engine/planelet_config.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/list_tree.h"

/* A node whose turn comes, and the child of which it is. */
typedef struct waiting {
    plt_box box;
    uint32_t slot, parent;
    int child;
} waiting;

static void read_node(node_tree *t, uint32_t (*children)[2], float *area, const waiting *at,
                      uint32_t number) {
    t->slot[number] = at->slot;
    children[number][0] = children[number][1] = TREELET_NO_NODE;
    area[number] = (float)list_tree_half_area(&at->box);
    if (number > 0) {
        children[at->parent][at->child] = number;
    }
}

int node_tree_read(node_tree *t, const plt_node *nodes, uint32_t root, uint32_t count,
                   const plt_box *box) {
    waiting stack[PLT_DEPTH_MAX + 2] = {{*box, root, 0, 0}};
    uint32_t(*children)[2] = heap_get((uint64_t)count * sizeof *children);
    float *area = heap_get((uint64_t)count * sizeof *area);
    uint32_t depth = 1, number = 0;
    t->slot = heap_get((uint64_t)count * sizeof *t->slot);
    t->tree = (treelet_tree){.child = (const uint32_t(*)[2])children, .area = area, .nodes = count};
    if (children == NULL || area == NULL || t->slot == NULL) {
        node_tree_free(t);
        return -1;
    }
    for (; depth > 0; number++) {
        const waiting at = stack[--depth];
        plt_box child[2];
        read_node(t, children, area, &at, number);
        plt_node_decode(&nodes[at.slot], &at.box, child);
        for (int k = 1; k >= 0; k--) {
            const uint32_t link = plt_node_link(&nodes[at.slot], k);
            if (!plt_link_is_leaf(link)) {
                stack[depth++] = (waiting){child[k], plt_link_index(link), number, k};
            }
        }
    }
    return 0;
}

void node_tree_free(node_tree *t) {
    heap_drop((void *)t->tree.child);
    heap_drop((void *)t->tree.area);
    heap_drop(t->slot);
    *t = (node_tree){.slot = NULL};
}

static uint32_t bit_of(const treelet_layout *l, enum node_edges edges, uint32_t from, uint32_t to) {
    const int is_set =
        edges == NODE_EDGES_DIRECT ? treelets_leaves(l, from, to) : l->parity[l->treelet[to]];
    return is_set ? PLT_LINK_OUT : 0;
}

void node_tree_write(const node_tree *t, const treelet_layout *l, uint32_t size,
                     enum node_edges edges, const plt_node *from, plt_node *to) {
    memset(to, 0, (size_t)l->blocks * size * sizeof *to);
    for (uint32_t i = 0; i < t->tree.nodes; i++) {
        plt_node *node = &to[l->slot[i]];
        *node = from[t->slot[i]];
        for (int k = 0; k < 2; k++) {
            const uint32_t child = t->tree.child[i][k];
            if (child != TREELET_NO_NODE) {
                plt_node_relink(node, k, plt_link_make(l->slot[child], bit_of(l, edges, i, child)));
            }
        }
    }
}
