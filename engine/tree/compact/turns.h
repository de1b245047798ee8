/* turns - leaves of a block that moves, one after the other, and what turns their triangles
 *
 * The order of a triangle's corners (canonical.h) goes by where they are, so it changes from frame
 * to frame, and with it the rotation that its id holds. Behind the positions, two bits per triangle
 * say which corner of the strip's order is the mesh's first: that stays.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_COMPACT_TURNS_H
#define PLT_TREE_COMPACT_TURNS_H

#include "engine/tree/compact/leaf.h"

/* Reads leaf `number` of the block, a pair or not, which begins at `at`; there can be fewer
 * triangles in front of it than in the block. */
void plt_leaf_read_next(const plt_geometry *g, plt_leaf_place *at, uint32_t number, int pair,
                        plt_leaf *leaf);

/* Goes on behind it. */
static inline void plt_leaf_pass(const plt_geometry *g, plt_leaf_place *at, const plt_leaf *leaf) {
    const uint32_t begin = g->news + at->slot;
    at->first += at->count;
    at->news += plt_bits_count(g->bytes, begin, begin + leaf->vertices);
    at->slot += leaf->vertices;
}

/* Writes the rotations of its triangles into their ids, `bits` each, of which that of image index 0
 * would begin at `ids`. */
void plt_leaf_turn(const plt_geometry *g, const plt_leaf_place *at, const plt_leaf *leaf,
                   unsigned char *ids, uint32_t bits);

/* The same of all triangles of a block that is streamed, whose first id begins in the first byte of
 * `ids`. */
void plt_block_turn(const plt_block *b, const plt_geometry *g, unsigned char *ids, uint32_t bits);

#endif
