/* tree - a scene of thesis nodes and float records, as the traversal sees it
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_THESIS_TREE_H
#define PLT_TREE_THESIS_TREE_H

#include "engine/planelet_config.h"
#include "engine/tree/record.h"
#include "engine/tree/thesis/node.h"

typedef struct plt_tree {
    const plt_node *nodes;
    const plt_record *records;
#if PLT_WITH_VERTICES
    const uint32_t
        *words; /* NULL: those of the records; else of each its id word, and no records */
#endif
    uint32_t node_slots, records_count;
    uint32_t treelet_nodes; /* slots per treelet block, 1 or more */
    uint32_t root;          /* link, or PLT_LINK_NONE */
} plt_tree;

static inline int plt_tree_is_last(const plt_tree *tree, uint32_t record) {
#if PLT_WITH_VERTICES
    if (tree->words != NULL) {
        return (plt_get_u32(&tree->words[record]) & PLT_RECORD_LAST) != 0;
    }
#endif
    return plt_record_is_last(&tree->records[record]);
}

#endif
