/* block_record - a triangle of a compact block by itself, as a float record
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_COMPACT_BLOCK_RECORD_H
#define PLT_TREE_COMPACT_BLOCK_RECORD_H

#include "engine/tree/compact/block_tree.h"

#if PLT_WITH_SURFACE && PLT_WITH_COMPACT

/* The triangles of the block at `address`, of a tree that is valid: the image index of the first,
 * and how many; returns the address of the next block. */
uint32_t plt_block_triangles(const plt_block_tree *tree, uint32_t address, uint32_t *first,
                             uint32_t *count);

/* The corners of a triangle of a leaf that has been read, in canonical order. */
void plt_leaf_record(const plt_lattice *lattice, const plt_leaf *leaf, uint32_t triangle,
                     plt_record *record);

/* Triangle `triangle` of that block, in canonical order, with its id word. Cost: the block's
 * strings are counted, some 500 instructions. */
void plt_block_record(const plt_block_tree *tree, uint32_t address, uint32_t triangle,
                      plt_record *record);

#endif
#endif
