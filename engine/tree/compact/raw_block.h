/* raw_block - a compact block as it lies, for one look at one node
 *
 * A packet opens a block once (block.h) and counts its masks for many visits. A single ray makes
 * four visits to a block, between which other rays are elsewhere: it takes what it needs from the
 * bytes themselves. Where the parts are follows from the number of nodes; ranks are counted over
 * all 128 bits of a mask, without a branch.
 *
 * Invariant: at most 8 bytes behind a block are read, as block_tree.h allows: a block of one node
 * has 9 bytes behind its bounds and 8 of links or geometry, and 17 + 8 are read.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_COMPACT_RAW_BLOCK_H
#define PLT_TREE_COMPACT_RAW_BLOCK_H

#include "engine/lanes/lanes.h"
#include "engine/tree/compact/block.h"

static inline uint32_t plt_raw_nodes(const unsigned char *block) {
    return (plt_get_u32(block) & 63u) + 1;
}

/* From a block to its masks, of which each has so many bytes. */
static inline uint32_t plt_raw_masks_at(uint32_t bits) {
    return PLT_BLOCK_HEADER_BYTES + plt_block_bounds_bytes(bits);
}

static inline uint32_t plt_raw_mask_bytes(uint32_t nodes) {
    return (nodes + 3) / 4;
}

/* From the masks to planes and links; owners are behind both masks. */
static inline uint32_t plt_raw_planes_at(uint32_t nodes) {
    return 2 * plt_raw_mask_bytes(nodes) + (5 * nodes + 7) / 8;
}

static inline uint32_t plt_raw_links_at(uint32_t nodes) {
    return plt_raw_planes_at(nodes) + 6 * nodes;
}

/* All slots of a kind, a bit each; those behind the last may be any. */
typedef struct plt_raw_masks {
    u4 no_leaf, inner, edge, pair;
} plt_raw_masks;

static inline plt_raw_masks plt_raw_masks_get(const unsigned char *masks, uint32_t nodes) {
    const u4 a = u4_load_bytes(masks), m = u4_load_bytes(masks + plt_raw_mask_bytes(nodes));
    const plt_raw_masks to = {a, u4_andnot(a, m), u4_and(a, m), u4_andnot(m, a)};
    return to;
}

#define PLT_RAW_ON 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255
static const unsigned char plt_raw_below[8][32] = {
    {PLT_RAW_ON},     {PLT_RAW_ON, 1},  {PLT_RAW_ON, 3},  {PLT_RAW_ON, 7},
    {PLT_RAW_ON, 15}, {PLT_RAW_ON, 31}, {PLT_RAW_ON, 63}, {PLT_RAW_ON, 127}};
#undef PLT_RAW_ON

/* Those below `slot`, 0 .. 128. */
static inline uint32_t plt_raw_rank(u4 kind, uint32_t slot) {
    return u4_ones(u4_and(kind, u4_load_bytes(&plt_raw_below[slot & 7u][16 - (slot >> 3)])));
}

#endif
