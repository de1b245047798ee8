/* tree - a scene of thesis nodes and float records, as the traversal sees it
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_THESIS_TREE_H
#define PLT_TREE_THESIS_TREE_H

#include "engine/tree/record.h"
#include "engine/tree/thesis/node.h"

typedef struct plt_tree {
    const plt_node *nodes;
    const plt_record *records;
    uint32_t node_slots, records_count;
    uint32_t treelet_nodes; /* slots per treelet block, 1 or more */
    uint32_t root;          /* link, or PLT_LINK_NONE */
} plt_tree;

#endif
