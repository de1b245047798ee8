/* validate_block - may this block be traversed?
 *
 * What has to hold of one block by itself (SPEC.md, I10 to I16 and I21), so that a
 * traversal and a reader of its leaves stay inside it.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_COMPACT_VALIDATE_BLOCK_H
#define PLT_TREE_COMPACT_VALIDATE_BLOCK_H

#include "engine/tree/compact/block_tree.h"

enum plt_block_rule {
    PLT_BLOCK_VALID = 0,
    PLT_BLOCK_RULE_SIZES = 10,      /* the parts fit the block's sizes and the section */
    PLT_BLOCK_RULE_KINDS = 11,      /* n - 1 inner children, in breadth-first order */
    PLT_BLOCK_RULE_BOUNDS = 12,     /* the bounds are a box inside the scene's */
    PLT_BLOCK_RULE_CHECK = 13,      /* both parts' checks are right */
    PLT_BLOCK_RULE_GEOMETRY = 14,   /* counts, strips and vertices fit the geometry part */
    PLT_BLOCK_RULE_LEAVES = 15,     /* every leaf begins a strip and has at most 2 K triangles */
    PLT_BLOCK_RULE_REFERENCES = 16, /* references name vertices already met */
    PLT_BLOCK_RULE_LINKS = 17,      /* links lead forward, to each block once */
    PLT_BLOCK_RULE_COUNTS = 18,     /* the header's counts are the blocks' */
    PLT_BLOCK_RULE_VERTICES = 21    /* vertices lie inside the bounds */
};

/* The invariants of one block that has arrived whole; `limit` bounds the bytes
 * from its start. Returns PLT_BLOCK_VALID, or the rule that is broken.
 * A valid block can be traversed and its leaves read without leaving it. */
int plt_block_validate(const unsigned char *bytes, uint32_t limit, const plt_block_tree *tree);

/* What a broken rule means, as a sentence. */
const char *plt_block_rule_message(int rule);

#endif
