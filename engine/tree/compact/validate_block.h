/* validate_block - may this block be traversed?
 *
 * What has to hold of one block by itself (SPEC.md, I10 to I16 and I21), so that a
 * traversal and a reader of its leaves stay inside it.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_COMPACT_VALIDATE_BLOCK_H
#define PLT_TREE_COMPACT_VALIDATE_BLOCK_H

#include "engine/base/rules.h"
#include "engine/tree/compact/block_tree.h"

#define PLT_BLOCK_VALID 0

/* The invariants of one block that has arrived whole; `limit` bounds the bytes
 * from its start. Returns PLT_BLOCK_VALID, or the rule that is broken,
 * of enum plt_invariant. A valid block can be traversed and its leaves read without
 * leaving it. */
int plt_block_validate(const unsigned char *bytes, uint32_t limit, const plt_block_tree *tree);

/* The same of its two parts, which may come one after the other: I10 to I13 of the nodes part,
 * of which `there` bytes have come, in a block that has `limit` bytes at most; then I13 to I16
 * and I21 of the geometry part of a block that is opened and that valid. */
int plt_block_validate_nodes(plt_block *block, const unsigned char *bytes, uint32_t there,
                             uint32_t limit, const plt_block_tree *tree);
int plt_block_validate_geometry(const plt_block *block, const plt_block_tree *tree);

/* How deep each node lies in a block, its root at 1, all other blocks left out. Returns the
 * deepest. */
uint32_t plt_block_depths(const plt_block *block, uint16_t depth[PLT_BLOCK_NODES_MOST]);

/* What a broken rule means, as a sentence. */
const char *plt_block_rule_message(int rule);

#endif
