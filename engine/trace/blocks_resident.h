/* blocks_resident - compact blocks that are all at hand, mapped or in the arena
 *
 * What format_compact.h asks of it, here and in blocks_streamed.h:
 *
 *   format_state                    and format_state_init(t)
 *   void blocks_leave(state)        no block is the current one
 *   int blocks_open(t, link, end)   the block behind `link` becomes the current one; `end` is where
 *                                   its subtree ends
 *   int blocks_return(t, link, end, target)      the same, to a place that has waited in it
 *   blocks_current(t)               the current block, opened
 *   int blocks_open_geometry(t)     ... and its geometry part; PLT_OK, or as blocks_open
 *   int blocks_at_hand(t, link)     the block behind `link` need not be fetched
 *   int blocks_geometry_at_hand(t)  nor the current block's geometry part
 *   blocks_tree(t)                  the tree that its leaves are read by
 *   void blocks_prefetch(t, b, node)             asks for the blocks behind the node's edges
 *   float blocks_root_end(tree)     where the whole tree ends
 *   float blocks_edge_end(o, link)  where the subtree behind an edge of the block ends
 *   void blocks_set_end(hi, end)    notes it in a place; here nobody needs it
 *   void blocks_keep(t, p, run, groups)          triangles of the run that they hit, if they are
 * kept
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_BLOCKS_RESIDENT_H
#define PLT_TRACE_BLOCKS_RESIDENT_H

#include "engine/trace/block_entry.h"

#define PLT_BLOCKS_RESIDENT 1

typedef plt_block_state format_state;

static inline void format_state_init(plt_traversal *t) {
    plt_block_state_init((format_state *)t->state);
}

static inline void blocks_leave(format_state *state) {
    state->current = NULL;
}

static inline plt_opened_block *blocks_current(const plt_traversal *t) {
    return ((const format_state *)t->state)->current;
}

static inline const plt_block_tree *blocks_tree(const plt_traversal *t) {
    return &t->scene->compact;
}

static inline int blocks_open(plt_traversal *t, uint32_t link, float end) {
    (void)end;
    plt_block_enter(t, link);
    return PLT_OK;
}

static inline int blocks_return(plt_traversal *t, uint32_t link, float end, uint32_t target) {
    (void)target;
    return blocks_open(t, link, end);
}

static inline int blocks_open_geometry(plt_traversal *t) {
    plt_block_enter_geometry(t);
    return PLT_OK;
}

static inline int blocks_at_hand(const plt_traversal *t, uint32_t link) {
    (void)t;
    (void)link;
    return 1;
}

static inline int blocks_geometry_at_hand(const plt_traversal *t) {
    (void)t;
    return 1;
}

/* Before it is known whether they are met. */
static inline void blocks_prefetch(const plt_traversal *t, const plt_block *b, uint32_t node) {
    const uint32_t word = node >> 4, shift = node << 1 & 31, edge = b->mask[PLT_SLOT_EDGE][word];
    if ((edge >> shift & 3u) == 0) {
        return;
    }
    const uint32_t edges =
        b->before[PLT_SLOT_EDGE][word] + plt_count_bits(edge & plt_low_bits(shift));
    for (uint32_t i = 0; i < plt_count_bits(edge >> shift & 3u); i++) {
        plt_prefetch(t->scene->compact.bytes + plt_block_address(plt_block_edge(b, edges + i)));
    }
}

static inline float blocks_root_end(const plt_block_tree *tree) {
    (void)tree;
    return 0.0f;
}

static inline float blocks_edge_end(const plt_opened_block *o, uint32_t link) {
    (void)o;
    (void)link;
    return 0.0f;
}

static inline void blocks_set_end(float hi[4], float end) {
    (void)hi;
    (void)end;
}

static inline void blocks_keep(const plt_traversal *t, const plt_packet *p, const void *run,
                               plt_mask groups) {
    (void)t;
    (void)p;
    (void)run;
    (void)groups;
}

#endif
