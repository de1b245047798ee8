/* validate_thesis - thesis trees of a scene against the rules and the header's counts
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_VALIDATE_THESIS_H
#define PLT_SCENE_VALIDATE_THESIS_H

#include "engine/scene/opening.h"

/* The tree keeps I1 to I4 and needs no more than PLT_GLOBAL_STACK_MAX entries, read or
 * built; `counted`: what it holds and needs, the rest as in the scene's
 * info, but leaf_triangles is the longest list. Offsets of faults: tree/thesis/validate.h. */
int plt_thesis_validate(const plt_opening *o, const plt_tree *tree, plt_info *counted);

/* The same for a tree of an image, whose planes keep I6 and whose header has the counts
 * (I8); offsets of faults are those in the image. */
int plt_thesis_validate_image(const plt_opening *o, const plt_header *header, const plt_tree *tree);

/* Where in the image that is which plt_tree_validate found fault with; its root link is at
 * `root_at`. */
uint32_t plt_thesis_offset_in_image(const plt_header *header, const plt_fault *fault,
                                    uint32_t root_at);

#endif
