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

static inline uint32_t plt_greater_count(uint32_t a, uint32_t b) {
    return a > b ? a : b;
}

/* Of several trees in one image: what a validation counts is added up, and K and what stacks need
 * are the greatest. */
static inline void plt_counts_add(plt_info *sum, const plt_info *one) {
    sum->nodes += one->nodes;
    sum->leaf_lists += one->leaf_lists;
    sum->intermediate_lists += one->intermediate_lists;
    sum->treelets += one->treelets;
    sum->leaf_triangles = plt_greater_count(sum->leaf_triangles, one->leaf_triangles);
    sum->local_stack_entries =
        plt_greater_count(sum->local_stack_entries, one->local_stack_entries);
    sum->global_stack_entries =
        plt_greater_count(sum->global_stack_entries, one->global_stack_entries);
    sum->depth_stack_entries =
        plt_greater_count(sum->depth_stack_entries, one->depth_stack_entries);
}

#endif
