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

/* What a broken rule means, as a sentence. */
const char *plt_block_rule_message(int rule);

#endif
