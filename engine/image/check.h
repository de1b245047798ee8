/* check - where the contents of thesis nodes and float records are believed
 *
 * They pass here once, when an image is opened; nothing behind it checks again
 * (SPEC.md, section 5). Compact blocks pass tree/block_survey.h.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_IMAGE_CHECK_H
#define PLT_IMAGE_CHECK_H

#include "engine/image/header.h"
#include "engine/tree/survey.h"

/* I5 and I7: corners finite and inside the scene's box, number words in range. */
int plt_check_records(const plt_header *header, const plt_record *records, plt_fault *fault);

/* I6: planes inside the scene's box, for every slot of a node in use or not. */
int plt_check_planes(const plt_header *header, const plt_node *nodes, plt_fault *fault);

/* I1 to I4 by a survey of the tree, and I8: counts and stack needs of the
 * header are the tree's. */
int plt_check_tree(const plt_header *header, const plt_tree *tree, plt_survey_frame *frames,
                   plt_fault *fault);

#endif
