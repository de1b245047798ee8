/* block_refit_check - is a tree of compact blocks what a refit shall make of it?
 *
 * In whole numbers and by recursion, from SPEC.md: every triangle lies where its frame says, bounds
 * are exact, and planes and owners are the tightest that one step allows; boxes as a traversal
 * decodes them contain what is below.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_BLOCK_REFIT_CHECK_H
#define REFERENCE_BLOCK_REFIT_CHECK_H

#include "engine/tree/compact/block_tree.h"
#include "host_tools/mesh/mesh.h"

typedef struct block_refit_facts {
    uint32_t broken; /* 0: all is well */
    const char *sentence;
    uint32_t triangles, nodes, blocks;
    uint32_t loose; /* planes that their owner's rule leaves farther out than a step */
} block_refit_facts;

/* `m`: the frame, on the lattice; triangles of the tree by their primitive ids, if it has any. */
block_refit_facts block_refit_check(const plt_block_tree *tree, const mesh *m);

#endif
