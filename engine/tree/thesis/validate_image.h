/* validate_image - where the contents of thesis nodes and float records are believed
 *
 * They pass here once, when an image is opened; nothing behind it checks again
 * (SPEC.md, section 5). Compact blocks pass tree/block_survey.h.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_THESIS_VALIDATE_IMAGE_H
#define PLT_TREE_THESIS_VALIDATE_IMAGE_H

#include "engine/image/header.h"
#include "engine/tree/thesis/validate.h"

/* I5 and I7: corners finite and inside the scene's box, number words in range. */
int plt_records_validate(const plt_header *header, const plt_record *records, plt_fault *fault);

/* I6: planes inside the scene's box, for every slot of a node in use or not. */
int plt_planes_validate(const plt_header *header, const plt_node *nodes, plt_fault *fault);

/* I1 to I4 by a survey of the tree, and I8: counts and stack needs of the
 * header are the tree's. */
int plt_tree_validate_counts(const plt_header *header, const plt_tree *tree,
                             plt_validate_level *frames, plt_fault *fault);

#endif
