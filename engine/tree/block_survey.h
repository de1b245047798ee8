/* block_survey - is a section of compact blocks what its header says?
 *
 * One walk over all blocks along their links, the counterpart of survey.h: each
 * block is checked when the walk arrives there (plt_block_is_sound, SPEC.md
 * I10 to I16), links lead forward and blocks are met in the order in which they
 * lie, so that every block is met once. Needs a frame a block on the path.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_BLOCK_SURVEY_H
#define PLT_TREE_BLOCK_SURVEY_H

#include "engine/planelet.h"
#include "engine/tree/numbers.h"
#include "engine/tree/record.h"
#include "engine/tree/unit.h"

/* Compact blocks as the traversal sees them. */
typedef struct plt_block_tree {
    const unsigned char *bytes; /* block address 0; 8 bytes behind may be read */
    uint32_t used;              /* bytes of blocks */
    uint32_t root;              /* link, or PLT_MISS */
    uint32_t leaf_triangles;
    plt_lattice lattice;
    plt_lattice_box box; /* of all triangles */
    plt_numbers numbers;
    const plt_record *records; /* float geometry, in image order; NULL: lattice */
} plt_block_tree;

typedef struct plt_block_frame_of_survey {
    uint32_t address, depth; /* depth: nodes above its root */
    uint32_t node_bytes;     /* as the link to it says */
    uint32_t last;           /* address of the block behind the last edge taken */
} plt_block_frame_of_survey;

/* The invariants of one block that has arrived whole; `limit` bounds the bytes
 * from its start. Returns 0 when sound, or the number of the rule that is broken.
 * A sound block can be walked and its units read without leaving it. */
int plt_block_is_sound(const unsigned char *bytes, uint32_t limit, const plt_block_tree *tree);

/* Fills nodes, lists, treelets, triangles and the depth-first need of `info`. */
int plt_block_survey(const plt_block_tree *tree, plt_block_frame_of_survey *frames, plt_info *info,
                     plt_fault *fault);

#endif
