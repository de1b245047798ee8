/* compact_check - checks a tree of compact blocks by recursion
 *
 * The triangles come from the packer's snapped mesh, not from the blocks: every one must be
 * found once, inside every box above it. Boxes and bounds are decoded here from the bytes
 * (SPEC.md, 4.9); strips are read by the engine.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_COMPACT_CHECK_H
#define REFERENCE_COMPACT_CHECK_H

#include "engine/tree/compact/validate.h"
#include "host_tools/pack/snapped.h"

typedef struct compact_facts {
    uint32_t blocks, nodes, leaves, pairs, triangles, depth;
    uint32_t longest_leaf, largest_block, most_vertices; /* bytes with padding */
    uint32_t broken;                                     /* promises broken; 0: a good tree */
    const char *sentence;                                /* the first of them */
} compact_facts;

/* A scene of one triangle contains it twice; with `s` NULL the triangles are not compared. */
compact_facts compact_check(const plt_block_tree *tree, const snapped *s);

#endif
