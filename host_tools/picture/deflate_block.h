/* deflate_block - one deflate block: literals and matches in, the shortest coding out
 *
 * Invariant: `literals` and `distances` count what is in `token`.
 *
 * SPDX-License-Identifier: MIT */
#ifndef DEFLATE_BLOCK_H
#define DEFLATE_BLOCK_H
#include "host_tools/picture/bits.h"

#define DEFLATE_TOKENS 32768
#define DEFLATE_LITERALS 286 /* 256 bytes, end of block, 29 lengths */
#define DEFLATE_DISTANCES 30

typedef struct deflate_block {
    uint32_t token[DEFLATE_TOKENS]; /* byte, or match: bit 31, length - 3, distance - 1 */
    unsigned tokens;
    uint32_t literals[DEFLATE_LITERALS], distances[DEFLATE_DISTANCES];
} deflate_block;

void deflate_block_clear(deflate_block *b);

/* Both need tokens < DEFLATE_TOKENS; length 3 .. 258, distance 1 .. 32768. */
void deflate_block_literal(deflate_block *b, uint8_t byte);
void deflate_block_match(deflate_block *b, unsigned length, unsigned distance);

/* Writes the block, which stands for raw[0 .. size), stored, with the fixed
 * or with its own codes, whichever is shortest, and clears it. */
void deflate_block_write(deflate_block *b, const uint8_t *raw, size_t size, int last, bits *out);

#endif
