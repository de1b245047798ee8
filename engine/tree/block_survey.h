/* block_survey - is a section of compact blocks what its header says?
 *
 * One walk over all blocks along their links, the counterpart of survey.h: each
 * block is checked when the walk arrives there (block_sound.h), links lead forward
 * and blocks are met in the order in which they lie, so that every block is met
 * once. Needs a frame a block on the path.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_BLOCK_SURVEY_H
#define PLT_TREE_BLOCK_SURVEY_H

#include "engine/planelet.h"
#include "engine/tree/block_tree.h"

typedef struct plt_block_frame_of_survey {
    uint32_t address, depth; /* depth: nodes above its root */
    uint32_t node_bytes;     /* as the link to it says */
    uint32_t last;           /* address of the block behind the last edge taken */
} plt_block_frame_of_survey;

/* Fills nodes, lists, treelets, triangles and the depth-first need of `info`. */
int plt_block_survey(const plt_block_tree *tree, plt_block_frame_of_survey *frames, plt_info *info,
                     plt_fault *fault);

#endif
