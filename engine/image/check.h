/* check - the one place where the contents of an image are believed
 *
 * Everything that enters the engine passes here once, when it is opened;
 * nothing behind it checks again (SPEC.md, section 5).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_IMAGE_CHECK_H
#define PLT_IMAGE_CHECK_H

#include "engine/image/header.h"
#include "engine/tree/survey.h"

/* I5 to I7: corners finite and inside the scene's box, source numbers below
 * the count. */
int plt_check_records(const plt_header *header, const plt_record *records, plt_fault *fault);

/* I6: planes inside the scene's box, for every slot of a node in use or not. */
int plt_check_planes(const plt_header *header, const plt_node *nodes, plt_fault *fault);

/* I1 to I4 by a survey of the tree, and I8: counts and stack needs of the
 * header are the tree's. */
int plt_check_tree(const plt_header *header, const plt_tree *tree, plt_survey_frame *frames,
                   plt_fault *fault);

#endif
