/* validate - is a section of compact blocks what its header says?
 *
 * One traversal of all blocks along their links, the counterpart of
 * tree/thesis/validate.h. Each block is validated when the traversal enters it
 * (validate_block.h). Links lead forward, and blocks are met in the order in which
 * they lie: so every block is met once. It needs one level of scratch per block on
 * the path.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_COMPACT_VALIDATE_H
#define PLT_TREE_COMPACT_VALIDATE_H

#include "engine/planelet.h"
#include "engine/tree/compact/block_tree.h"

/* A block on the path from the root. */
typedef struct plt_blocks_validate_level {
    uint32_t address, depth; /* depth: nodes above its root */
    uint32_t node_bytes;     /* as the link to it says */
    uint32_t last;           /* address of the block behind the last edge followed */
} plt_blocks_validate_level;

/* Fills nodes, lists, treelets, triangles and the depth-first need of `info`. `levels`
 * is scratch of PLT_DEPTH_MAX. */
int plt_blocks_validate(const plt_block_tree *tree, plt_blocks_validate_level *levels,
                        plt_info *info, plt_fault *fault);

#endif
