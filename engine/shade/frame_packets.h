/* frame_packets - a frame whose packets are traced elsewhere, several at a time
 *
 * Packets are begun in the order of the tiles, and taken back in the same.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_FRAME_PACKETS_H
#define PLT_SHADE_FRAME_PACKETS_H

#include "engine/shade/rendering.h"

/* The top left pixel of the next packet to be begun; 0: there is none that is wanted. */
int plt_frame_next(plt_rendering *r, uint32_t pixel[2]);

/* All that were begun are taken back: if the frame is not over, others are wanted. */
void plt_frame_go_on(plt_rendering *r);

/* Sets the packet at `pixel` up; how many rays it has. `scene`: as for plt_packet_begin. */
uint32_t plt_frame_packet(const plt_rendering *r, const plt_box *scene, const uint32_t pixel[2],
                          plt_packet *packet);

/* Its colours, as many in a row as lie in the frame. */
void plt_frame_shade(const plt_rendering *r, const uint32_t pixel[2], const plt_packet *packet,
                     uint8_t *rgb);

/* The colours of the oldest packet that was begun go into its tile. PLT_TILE: it was the last of
 * it; or PLT_OK. */
int plt_frame_take(plt_rendering *r, const uint8_t *rgb);

/* After PLT_TILE: to the next tile. 1: the frame is over. */
int plt_frame_ended(plt_rendering *r);

#endif
