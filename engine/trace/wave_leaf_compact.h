/* wave_leaf_compact - the triangles of a leaf of compact blocks, for one ray
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WAVE_LEAF_COMPACT_H
#define PLT_TRACE_WAVE_LEAF_COMPACT_H

#include "engine/tree/bvh4.h"
#include "engine/tree/compact/block_tree.h"

enum { PLT_WAVE_LEAF_BLOCKS_MOST = (PLT_LEAF_TRIANGLES_MOST + 3) / 4 };

/* Where it is: which slot of the block behind `link`, which has so many nodes. */
typedef struct plt_wave_leaf {
    uint32_t link, nodes, slot;
} plt_wave_leaf;

/* Its triangles: the first in image order, and how many. */
typedef struct plt_wave_leaf_run {
    uint32_t first, count;
} plt_wave_leaf_run;

/* Reads them into blocks of four. `to` is at a multiple of 16. */
plt_wave_leaf_run plt_wave_leaf_load(const plt_block_tree *tree, const plt_wave_leaf *leaf,
                                     plt_bvh4_block to[PLT_WAVE_LEAF_BLOCKS_MOST]);

/* Sets the id words of block `number` of a run: seldom needed, and they lie far away. */
void plt_wave_leaf_words(const plt_block_tree *tree, const plt_wave_leaf_run *run, uint32_t number,
                         plt_bvh4_block *block);

#endif
