/* validate - is a section of compact blocks what its header says?
 *
 * One walk over all blocks along their links, the counterpart of survey.h: each
 * block is checked when the walk arrives there (block_sound.h), links lead forward
 * and blocks are met in the order in which they lie, so that every block is met
 * once. Needs a frame a block on the path.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_COMPACT_VALIDATE_H
#define PLT_TREE_COMPACT_VALIDATE_H

#include "engine/planelet.h"
#include "engine/tree/compact/block_tree.h"

typedef struct plt_blocks_validate_level {
    uint32_t address, depth; /* depth: nodes above its root */
    uint32_t node_bytes;     /* as the link to it says */
    uint32_t last;           /* address of the block behind the last edge taken */
} plt_blocks_validate_level;

/* Fills nodes, lists, treelets, triangles and the depth-first need of `info`. */
int plt_blocks_validate(const plt_block_tree *tree, plt_blocks_validate_level *frames,
                        plt_info *info, plt_fault *fault);

#endif
