/* block_entry - the current block of a traversal of resident compact blocks
 *
 * Blocks stay opened from visit to visit (memory/block_cache.h). What enters one also counts it.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_BLOCK_ENTRY_H
#define PLT_TRACE_BLOCK_ENTRY_H

#include "engine/memory/block_cache.h"
#include "engine/memory/traffic.h"
#include "engine/trace/block_target.h"
#include "engine/trace/traversal.h"

typedef struct plt_block_state {
    plt_opened_block *current; /* NULL: none */
    uint8_t geometry_counted;  /* its geometry part is in the statistics */
    plt_opened_block cache[PLT_BLOCK_CACHE_SLOTS];
} plt_block_state;

static inline void plt_block_state_init(plt_block_state *state) {
    state->current = NULL;
    plt_block_cache_clear(state->cache);
}

/* Makes the block behind `link` the current one. */
static inline plt_opened_block *plt_block_enter(plt_traversal *t, uint32_t link) {
    plt_block_state *c = (plt_block_state *)t->state;
    if (c->current != NULL && link == c->current->link) {
        return c->current;
    }
    c->current = plt_block_cache_find(c->cache, &t->scene->compact, link);
    c->geometry_counted = 0;
    t->stats.treelet_fetches++;
    plt_traffic_count(&t->stats, t->touched, plt_block_address(link) / 8,
                      c->current->block.node_bytes);
    return c->current;
}

/* The current block, its geometry part opened, too. */
static inline plt_opened_block *plt_block_with_geometry(const plt_traversal *t) {
    plt_opened_block *o = ((plt_block_state *)t->state)->current;
    if (!o->geometry_open) {
        plt_opened_block_geometry(o, &t->scene->compact);
    }
    return o;
}

/* The same, and counted. */
static inline plt_opened_block *plt_block_enter_geometry(plt_traversal *t) {
    plt_block_state *state = (plt_block_state *)t->state;
    plt_opened_block *o = plt_block_with_geometry(t);
    if (!state->geometry_counted) {
        state->geometry_counted = 1; /* beside the bit of the nodes part */
        plt_traffic_count(&t->stats, t->touched, plt_block_address(o->link) / 8 + 1,
                          o->block.geometry_bytes);
    }
    return o;
}

#endif
