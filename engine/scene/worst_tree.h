/* worst_tree - bounds for a tree that is not there yet
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_WORST_TREE_H
#define PLT_SCENE_WORST_TREE_H

#include "engine/planelet.h"

/* Counts, stack needs and sizes of the worst tree that the builder can make of an
 * image without one; of a finished one what `info` says. */
plt_info plt_worst_tree(const plt_info *info);

#endif
