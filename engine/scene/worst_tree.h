/* worst_tree - bounds for a tree that is not there yet
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_WORST_TREE_H
#define PLT_SCENE_WORST_TREE_H

#include "engine/planelet.h"

/* plt_info with every count and size at its upper bound, for an image whose tree the
 * engine builds; for another one `info` as it is. */
plt_info plt_worst_tree(const plt_info *info);

#if PLT_WITH_REBUILD
/* The same for a tree that is built again, of thesis nodes, where there are `room` slots; and the
 * slots of the largest that there can be. */
plt_info plt_rebuilt_tree(const plt_info *info, uint32_t room);
uint32_t plt_rebuilt_room(const plt_info *info);
#endif

#endif
