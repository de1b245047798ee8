/* validate_thesis - see validate_thesis.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/validate_thesis.h"

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/header_at.h"
#include "engine/scene/counts.h"
#include "engine/tree/thesis/validate.h"

int plt_thesis_validate(const plt_opening *o, const plt_tree *tree, plt_info *counted) {
    const size_t mark = o->arena->used;
    plt_validate_level *levels = plt_opening_cut(o, PLT_PART_VALIDATION);
    if (levels == NULL) {
        return plt_opening_arena_error(o);
    }
    *counted = o->scene->info;
    const int status = plt_tree_validate(tree, levels, counted, o->fault);
    plt_arena_release(o->arena, mark);
    /* Not in plt_tree_validate: a packer may pack for an engine that allows more. */
    return status == PLT_OK && counted->global_stack_entries > PLT_GLOBAL_STACK_MAX
               ? plt_limit(o->fault, "the scene needs more than PLT_GLOBAL_STACK_MAX entries")
               : status;
}

uint32_t plt_thesis_offset_in_image(const plt_header *header, const plt_fault *fault,
                                    uint32_t root_at) {
    if (fault->offset == PLT_AT_ROOT_LINK) {
        return root_at;
    }
    const int in_node = fault->rule <= PLT_I2_TREE;
    const uint32_t kind = in_node ? PLT_SECTION_NODES : PLT_SECTION_TRIANGLES;
    return plt_header_section(header, kind)->offset +
           fault->offset * (in_node ? PLT_NODE_BYTES : PLT_RECORD_BYTES);
}

int plt_thesis_validate_image(const plt_opening *o, const plt_header *header,
                              const plt_tree *tree) {
    plt_info counted;
    int status = plt_planes_validate(header, tree->nodes, o->fault);
    if (status != PLT_OK) {
        return status;
    }
    if (tree->root == PLT_LINK_NONE && tree->records_count > 0) {
        return plt_broken(o->fault, PLT_I4_LIST_ORDER, PLT_AT_ROOT,
                          "there are triangles but no tree");
    }
    status = plt_thesis_validate(o, tree, &counted);
    if (status == PLT_ERR_IMAGE) {
        o->fault->offset = plt_thesis_offset_in_image(header, o->fault, PLT_AT_ROOT);
    }
    if (status == PLT_OK && !plt_counts_agree(&header->info, &counted)) {
        return plt_broken(o->fault, PLT_I8_COUNTS, PLT_AT_COUNTS + 4,
                          "the header's counts are not the tree's");
    }
    return status;
}
