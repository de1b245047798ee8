/* validate_image - see validate_image.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/thesis/validate_image.h"

#include "engine/base/fault.h"

static uint32_t offset_in(const plt_section *section, uint32_t item, uint32_t item_bytes) {
    return section->offset + item * item_bytes;
}

/* False for NaN. */
static int inside(const plt_info *info, int axis, float x) {
    return x >= info->lo[axis] && x <= info->hi[axis];
}

int plt_records_validate(const plt_header *header, const plt_record *records, plt_fault *fault) {
    for (uint32_t i = 0; i < header->info.triangles; i++) {
        const uint32_t at = offset_in(&header->section[1], i, PLT_RECORD_BYTES);
        for (int k = 0; k < 9; k++) {
            if (!inside(&header->info, k % 3, plt_get_float(&records[i].word[k]))) {
                return plt_broken(fault, 5, at + 4 * (uint32_t)k,
                                  "a corner lies outside the scene's box");
            }
        }
        const uint32_t word = plt_get_u32(&records[i].word[9]);
        if (plt_primitive_id(word) >= header->info.triangles || plt_primitive_rotation(word) > 2 ||
            (word & PLT_PRIMITIVE_UNUSED) != 0) {
            return plt_broken(fault, 7, at + 36, "a triangle's number word is out of range");
        }
    }
    return PLT_OK;
}

int plt_planes_validate(const plt_header *header, const plt_node *nodes, plt_fault *fault) {
    const plt_info *info = &header->info;
    for (uint32_t i = 0; i < info->node_slots; i++) {
        for (int k = 0; k < 6; k++) {
            const float plane = plt_get_float(&nodes[i].word[k]);
            if (!inside(info, k % 3, plane) && plane != 0.0f) {
                return plt_broken(
                    fault, 6, offset_in(&header->section[0], i, PLT_NODE_BYTES) + 4 * (uint32_t)k,
                    "a plane lies outside the scene's box");
            }
        }
    }
    return PLT_OK;
}

static int same_counts(const plt_info *a, const plt_info *b) {
    return a->nodes == b->nodes && a->leaf_lists == b->leaf_lists &&
           a->intermediate_lists == b->intermediate_lists && a->treelets == b->treelets &&
           a->local_stack_entries == b->local_stack_entries &&
           a->global_stack_entries == b->global_stack_entries &&
           a->depth_stack_entries == b->depth_stack_entries &&
           a->leaf_triangles >= b->leaf_triangles;
}

int plt_tree_validate_counts(const plt_header *header, const plt_tree *tree,
                             plt_validate_level *frames, plt_fault *fault) {
    plt_info found = header->info;
    if (tree->root == PLT_LINK_NONE && tree->records_count > 0) {
        return plt_broken(fault, 4, 68, "there are triangles but no tree");
    }
    const int status = plt_tree_validate(tree, frames, &found, fault);
    if (status == PLT_ERR_IMAGE && fault->offset == PLT_AT_ROOT_LINK) {
        fault->offset = 68;
    } else if (status == PLT_ERR_IMAGE && fault->rule <= 2) {
        fault->offset = offset_in(&header->section[0], fault->offset, PLT_NODE_BYTES);
    } else if (status == PLT_ERR_IMAGE) {
        fault->offset = offset_in(&header->section[1], fault->offset, PLT_RECORD_BYTES);
    }
    if (status == PLT_OK && !same_counts(&header->info, &found)) {
        return plt_broken(fault, 8, 28, "the header's counts are not the tree's");
    }
    if (status == PLT_OK && found.global_stack_entries > PLT_GLOBAL_STACK_MAX) {
        return plt_limit(fault, "the scene needs more than PLT_GLOBAL_STACK_MAX entries");
    }
    return status;
}
