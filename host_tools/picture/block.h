/* block - one deflate block: literals and matches in, the shortest coding out
 *
 * Invariant: `literals` and `distances` count what is in `token`.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BLOCK_H
#define BLOCK_H
#include "host_tools/picture/bits.h"

#define BLOCK_TOKENS 32768
#define BLOCK_LITERALS 286 /* 256 bytes, end of block, 29 lengths */
#define BLOCK_DISTANCES 30

typedef struct block {
    uint32_t token[BLOCK_TOKENS]; /* byte, or match: bit 31, length - 3, distance - 1 */
    unsigned tokens;
    uint32_t literals[BLOCK_LITERALS], distances[BLOCK_DISTANCES];
} block;

void block_clear(block *b);

/* Both need tokens < BLOCK_TOKENS; length 3 .. 258, distance 1 .. 32768. */
void block_literal(block *b, uint8_t byte);
void block_match(block *b, unsigned length, unsigned distance);

/* Writes the block, which stands for raw[0 .. size), stored, with the fixed
 * or with its own codes, whichever is shortest, and clears it. */
void block_write(block *b, const uint8_t *raw, size_t size, int last, bits *out);

#endif
