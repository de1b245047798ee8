/* block_tree - a scene of compact blocks, as the traversal sees it
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_COMPACT_BLOCK_TREE_H
#define PLT_TREE_COMPACT_BLOCK_TREE_H

#include "engine/base/lattice.h"
#include "engine/planelet_config.h"
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
    uint8_t ids_check_bytes; /* at the end of geometry parts, the check of their ids; 0: no check */
#if PLT_WITH_BLOCK_MOTION
    uint16_t salt; /* of checks, by the frame whose blocks these are (plt_still_salt) */
    uint8_t moves; /* positions are lattice coordinates themselves, not offsets in the bounds */
#endif
    plt_lattice lattice;
    plt_lattice_box box; /* of all triangles */
    plt_primitive_ids ids;
    const plt_record *records; /* of PLT_LEAF_RECORDS */
} plt_block_tree;

/* Checks of the parts of frame `frame` differ from what they are elsewhere by this: a block that is
 * there still from another frame is noticed. */
static inline uint16_t plt_still_salt(uint32_t frame) {
    return (uint16_t)(frame * 40503u);
}

static inline uint32_t plt_block_tree_salt(const plt_block_tree *tree) {
#if PLT_WITH_STILLS
    return tree->salt;
#else
    (void)tree;
    return 0;
#endif
}

/* Bits per triangle behind the positions: which corner of a strip's is the mesh's first. */
static inline uint32_t plt_turn_bits(const plt_block_tree *tree) {
#if PLT_WITH_BLOCK_MOTION
    return tree->moves && tree->ids.bits > 0 ? 2 : 0;
#else
    (void)tree;
    return 0;
#endif
}

/* What positions of a block's vertices are offsets in: its bounds, or, where triangles move, all
 * of the lattice. */
static inline void plt_block_tree_frame(const plt_block_tree *tree, plt_lattice_box *bounds) {
#if PLT_WITH_BLOCK_MOTION
    for (int a = 0; a < 3 && tree->moves; a++) {
        bounds->lo[a] = 0;
        bounds->hi[a] = plt_low_bits(tree->lattice.bits);
    }
#else
    (void)tree;
    (void)bounds;
#endif
}

#endif
