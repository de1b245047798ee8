/* treelet_entry - the current treelet of a traversal of thesis nodes
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TREELET_ENTRY_H
#define PLT_TRACE_TREELET_ENTRY_H

#include "engine/memory/traffic.h"
#include "engine/trace/traversal.h"

/* Treelets lie in aligned blocks of N slots; several small ones may share a block. */
typedef struct plt_treelet_state {
    uint32_t block; /* the current one, PLT_MISS: none */
} plt_treelet_state;

static inline void plt_treelet_state_init(plt_traversal *t) {
    ((plt_treelet_state *)t->state)->block = PLT_MISS;
}

/* Counts the block of the node behind a link if it is not the current one. */
static inline void plt_treelet_enter(plt_traversal *t, uint32_t link) {
    plt_treelet_state *state = (plt_treelet_state *)t->state;
    const uint32_t slots = t->scene->thesis.treelet_nodes;
    const uint32_t block = plt_link_index(link) / slots;
    if (block != state->block) {
        state->block = block;
        t->stats.treelet_fetches++;
        plt_traffic_count(&t->stats, t->touched, block, slots * PLT_NODE_BYTES);
    }
}

#endif
