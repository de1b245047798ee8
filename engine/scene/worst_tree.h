/* worst_tree - bounds for a tree that is not there yet
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_WORST_TREE_H
#define PLT_SCENE_WORST_TREE_H

#include "engine/planelet.h"

/* plt_info with every count and size at its upper bound, for an image whose tree the
 * engine builds; for another one `info` as it is. */
plt_info plt_worst_tree(const plt_info *info);

#endif
