/* rendering - a frame, tile after tile, a bounded piece at a time
 *
 * Tiles go from left to right, top down, or as tile_order.h has it; the packets of a tile
 * from left to right, top down, the rays of a packet in Z order.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_RENDERING_H
#define PLT_SHADE_RENDERING_H

#include "engine/shade/rendering_state.h"

/* No frame is begun; `tile` is the buffer that finished tiles lie in, `beam` where a beam may
 * be, plt_beam_bytes(packet_side) of it: the memory of a packet, as it is one or the other. */
void plt_rendering_init(plt_rendering *r, uint8_t *tile, void *beam, uint32_t packet_side);

/* As plt_render_begin, plt_render_step and plt_render_tile. */
int plt_rendering_begin(plt_rendering *r, const plt_frame *frame, const plt_traversal *t);
int plt_rendering_step(plt_rendering *r, plt_traversal *t, plt_packet *packet, uint32_t visits);
void plt_rendering_tile(const plt_rendering *r, plt_tile *tile);

#if PLT_WITH_BATCH
/* The next batch, if there are any, begins with the packet at `at`; they end after `tiles` tiles.
 */
void plt_rendering_begin_batches(plt_rendering *r, uint32_t tiles);

/* `ahead` goes to the next packet that is wanted; 0: there is none. */
int plt_rendering_ahead(plt_rendering *r);
#else
static inline void plt_rendering_begin_batches(const plt_rendering *r, uint32_t tiles) {
    (void)r;
    (void)tiles;
}
#endif

#endif
