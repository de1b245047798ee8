/* block_place - a box in compact blocks and what it leads to
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_BLOCK_PLACE_H
#define PLT_TRACE_BLOCK_PLACE_H

#include <stdint.h>

typedef struct plt_block_place {
    float lo[4], hi[4]; /* lattice coordinates; of a streamed scene the fourth of hi is where
                         * the subtree of the place's block ends (plt_stream_end), else it
                         * means nothing, as that of lo does */
    uint32_t link;      /* of its block; of an edge the block behind it */
    uint32_t target;    /* block_target.h */
} plt_block_place;

#endif
