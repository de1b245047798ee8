/* compact_tree - what a header says of a tree of compact blocks
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_COMPACT_TREE_H
#define PLT_SCENE_COMPACT_TREE_H

#include "engine/image/header.h"
#include "engine/tree/compact/block_tree.h"

/* All but where its bytes are. */
static inline void plt_compact_describe(plt_block_tree *t, const plt_header *header) {
    t->root = header->root;
    t->leaf_triangles = header->info.leaf_triangles;
    t->leaf_kind =
        header->info.geometry_format == PLT_GEOMETRY_FLOAT ? PLT_LEAF_RECORDS : PLT_LEAF_STRIPS;
    t->lattice = header->lattice;
    t->box = header->lattice_box;
    t->ids.bits = header->info.primitive_id_bits;
#if PLT_WITH_BLOCK_MOTION
    t->moves = (uint8_t)plt_header_moves(&header->info);
#endif
    t->ids_check_bytes = (uint8_t)(PLT_IDS_CHECK_BYTES * header->info.has_checks);
}

#endif
