/* rendering - a frame, tile after tile, a bounded piece at a time
 *
 * Tiles go from left to right, top down; the packets of a tile likewise, the rays of a
 * packet in Z order.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_RENDERING_H
#define PLT_SHADE_RENDERING_H

#include "engine/shade/camera.h"
#include "engine/trace/traversal.h"

#define PLT_TILE_BUFFER_BYTES (3 * PLT_TILE_SIDE * PLT_TILE_SIDE)

typedef struct plt_rendering {
    plt_frame frame;
    plt_view view;
    uint8_t *tile;   /* PLT_TILE_BUFFER_BYTES, rows as wide as the current tile */
    uint32_t side;   /* of a packet */
    uint32_t x, y;   /* current tile, pixels */
    uint32_t px, py; /* current packet, pixels within the tile */
    uint8_t tracing; /* the packet is set up and its traversal is not over */
    uint8_t done;    /* nothing left, or no frame begun */
} plt_rendering;

/* No frame is begun; `tile` is the buffer that finished tiles lie in. */
void plt_rendering_init(plt_rendering *r, uint8_t *tile, uint32_t packet_side);

/* As plt_render_begin, plt_render_step and plt_render_tile. */
int plt_rendering_begin(plt_rendering *r, const plt_frame *frame);
int plt_rendering_step(plt_rendering *r, plt_traversal *t, plt_packet *packet, uint32_t visits);
void plt_rendering_tile(const plt_rendering *r, plt_tile *tile);

#endif
