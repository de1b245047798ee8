/* validate_compact - see validate_compact.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/validate_compact.h"

#include "engine/tree/compact/validate.h"

int plt_compact_counts_agree(const plt_info *a, const plt_info *b) {
    return a->nodes == b->nodes && a->leaf_lists == b->leaf_lists &&
           a->intermediate_lists == b->intermediate_lists && a->treelets == b->treelets &&
           a->triangles == b->triangles && a->node_bytes == b->node_bytes &&
           a->node_slots == b->node_slots && a->local_stack_entries == b->local_stack_entries &&
           a->global_stack_entries == b->global_stack_entries &&
           a->depth_stack_entries == b->depth_stack_entries;
}

int plt_compact_validate(const plt_opening *o, plt_info *found) {
    const size_t mark = o->arena->used;
    *found = o->scene->info;
    plt_blocks_validate_level *levels = plt_opening_cut(o, PLT_PART_VALIDATION);
    if (levels == NULL) {
        return plt_opening_arena_error(o);
    }
    const int status = plt_blocks_validate(&o->scene->compact, levels, found, o->fault);
    plt_arena_release(o->arena, mark);
    return status;
}
