/* block_target - what the slots of a compact block lead to
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_BLOCK_TARGET_H
#define PLT_TRACE_BLOCK_TARGET_H

#include "engine/memory/block_cache.h"

/* Where a slot leads to. `target`, four bytes: enum plt_slot_kind, the index of the node or leaf
 * in its block, and of a leaf the pairs before it, and whether it is a pair. */
typedef struct plt_block_target {
    uint32_t link; /* of its block; of an edge the block behind it */
    uint32_t target;
} plt_block_target;

static inline uint32_t plt_target_kind(uint32_t target) {
    return target & 0xFFu;
}

static inline uint32_t plt_target_index(uint32_t target) {
    return target >> 8 & 0xFFu;
}

/* What slot `slot` of the block leads to. */
static inline plt_block_target plt_block_target_of(const plt_opened_block *o, uint32_t slot) {
    const plt_block *b = &o->block;
    const uint32_t word = slot >> 5, bit = 1u << (slot & 31), below = bit - 1u;
    const uint32_t inner = b->mask[PLT_SLOT_INNER][word], edge = b->mask[PLT_SLOT_EDGE][word];
    const uint32_t inners = b->before[PLT_SLOT_INNER][word] + plt_count_bits(inner & below);
    plt_block_target to = {o->link, PLT_SLOT_INNER | (inners + 1) << 8};
    if (inner & bit) {
        return to;
    }
    const uint32_t edges = b->before[PLT_SLOT_EDGE][word] + plt_count_bits(edge & below);
    if (edge & bit) {
        to.link = plt_block_edge(b, edges);
        to.target = PLT_SLOT_EDGE;
        return to;
    }
    const uint32_t pair = b->pair[word];
    const uint32_t pairs = b->pairs_before[word] + plt_count_bits(pair & below);
    to.target = PLT_SLOT_LEAF | (slot - inners - edges) << 8 | pairs << 16 |
                (uint32_t)((pair & bit) != 0) << 24;
    return to;
}

/* The first triangle of the leaf that `target` leads to, of the block's, and how many it has. */
static inline uint32_t plt_block_leaf(const plt_opened_block *o, uint32_t target, uint32_t *count) {
    return plt_leaf_find(&o->geometry, plt_target_index(target), target >> 16 & 0xFFu,
                         (int)(target >> 24), count);
}

#endif
