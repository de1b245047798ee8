/* block_tree - a scene of compact blocks, as the traversal sees it
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_COMPACT_BLOCK_TREE_H
#define PLT_TREE_COMPACT_BLOCK_TREE_H

#include "engine/base/lattice.h"
#include "engine/tree/compact/leaf.h"
#include "engine/tree/primitive_id.h"
#include "engine/tree/record.h"

/* What the leaves of the blocks are. */
enum plt_leaf_kind {
    PLT_LEAF_STRIPS, /* strips of lattice vertices, in the geometry part of each block */
    PLT_LEAF_RECORDS /* float records of a section, in image order */
};

typedef struct plt_block_tree {
    const unsigned char *bytes; /* block address 0; 8 bytes behind may be read */
    uint32_t used;              /* bytes of blocks */
    uint32_t root;              /* link, or PLT_LINK_NONE */
    uint32_t leaf_triangles;
    uint8_t leaf_kind;       /* enum plt_leaf_kind */
    uint8_t ids_are_checked; /* geometry parts end with the check of their ids */
    plt_lattice lattice;
    plt_lattice_box box; /* of all triangles */
    plt_primitive_ids ids;
    const plt_record *records; /* of PLT_LEAF_RECORDS */
} plt_block_tree;

#endif
