/* beam_streamed - the beam on its way through compact blocks that are fetched when it meets them
 *
 * SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "engine/trace/blocks_streamed.h"

#if PLT_WITH_PREFETCH
#define BEAM_STACK(t, bytes) (t)->entry_bytes = (uint16_t)(bytes)
#define BEAM_PAUSE(t) plt_prefetch_end(&((plt_stream *)(t)->state)->fetcher)
#endif

#define BEAM_BLOCKS streamed
#include "engine/shade/beam_blocks.h"

/* Where blocks_streamed.h looks for blocks that will be needed. */
_Static_assert(offsetof(plt_beam_block_entry, end) == offsetof(plt_block_place, hi[3]) &&
                   offsetof(plt_beam_block_entry, link) == offsetof(plt_block_place, link),
               "an entry begins as a place does");
