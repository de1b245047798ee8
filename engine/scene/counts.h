/* counts - are the counts that an image states those of its tree?
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_COUNTS_H
#define PLT_SCENE_COUNTS_H

#include "engine/planelet.h"

/* `counted` is `stated` with what a validation has counted put in. All counts and needs
 * are equal, but lists may be shorter than K. */
static inline int plt_counts_agree(const plt_info *stated, const plt_info *counted) {
    return stated->triangles == counted->triangles && stated->nodes == counted->nodes &&
           stated->node_slots == counted->node_slots && stated->node_bytes == counted->node_bytes &&
           stated->leaf_lists == counted->leaf_lists &&
           stated->intermediate_lists == counted->intermediate_lists &&
           stated->treelets == counted->treelets &&
           stated->local_stack_entries == counted->local_stack_entries &&
           stated->global_stack_entries == counted->global_stack_entries &&
           stated->depth_stack_entries == counted->depth_stack_entries &&
           stated->leaf_triangles >= counted->leaf_triangles;
}

#endif
