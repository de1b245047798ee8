/* subtree_slots - a new subtree in the slots of the old one
 *
 * Nodes of the new one are depth first, and so they come into the slots, from the first to the
 * last; a link that leaves a block of slots is an edge of a treelet, whichever treelet that is.
 * Slots that are left over stay the subtree's: their links are 0, as in a slot that nobody has.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_SUBTREE_SLOTS_H
#define PLT_MOTION_SUBTREE_SLOTS_H

#include "engine/motion/subtrees.h"

#if PLT_WITH_SUBTREES

/* Takes the subtree's nodes and lists off the counts of `info`, and puts its slots into `slot`, in
 * order. The tree stays as it is. */
void plt_subtree_slots(const plt_subtree *p, const plt_tree *tree, uint32_t *slot, plt_info *info);

/* `nodes` of `count`, the first of which is the root, and `records` are the subtree from now on,
 * and counted in `info`. Indices in them are their own. */
void plt_subtree_put(plt_subtree *p, plt_tree *tree, const plt_node *nodes, uint32_t count,
                     const plt_record *records, const uint32_t *slot, plt_info *info);

#endif
#endif
