/* blocks - compact blocks built top down, straight from triangles in place
 *
 * Triangles stay where they are (mapped flash, memory, or a source). What is
 * permuted is a list of their indices, 2 bytes each (4 above 65,536 triangles).
 * It lies at the far end of the memory, and the blocks that grow from the front
 * overwrite it. That is safe because ranges are consumed in order: all indices in front
 * of the range of the block in hand are in finished blocks and not read again, and a
 * block that would reach further is PLT_ERR_ARENA. Peak: the finished blocks and the
 * permutation of at most one block.
 *
 * A block fills by "largest subtree first, stop at subtrees that fit a block of
 * their own"; what is left becomes edges. Every block is complete when it is
 * written, except for its links, which are written when the blocks behind them get
 * their addresses, and its check.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BUILDER_BLOCKS_H
#define PLT_BUILDER_BLOCKS_H

#include "engine/builder/blocks_job.h"

/* Scratch for so many triangles: 29 KB up to 65,536, 34 KB above. */
size_t plt_blocks_scratch_bytes(uint32_t count);

/* Begins; then each step does a split or writes a block. PLT_OK: begun, or
 * done; PLT_MORE; PLT_ERR_ARENA (memory too small); PLT_ERR_LIMIT, from a step
 * only, and job->limit says which: depth, a block that cannot be made small enough,
 * or bytes of all blocks. */
int plt_blocks_begin(plt_blocks_job *job);
int plt_blocks_step(plt_blocks_job *job);

/* What job->limit means, as a sentence. */
const char *plt_blocks_limit_message(const plt_blocks_job *job);

/* After plt_blocks_begin, before the first step: the image order of the triangles, for a host that
 * wants it: if not NULL, order[i] becomes the index, in the job, of triangle i of the image. */
void plt_blocks_record_order(plt_blocks_job *job, uint32_t *order);

#endif
