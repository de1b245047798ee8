/* packet_rays - a packet from an array of rays, and its hits into one
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_PACKET_RAYS_H
#define PLT_TRACE_PACKET_RAYS_H

#include "engine/trace/packet.h"

/* The next four of `count` rays, or as many as there are, as group `index`
 * (plt_packet_set_group). */
void plt_packet_load_rays(plt_packet *packet, unsigned index, const plt_ray *rays, uint32_t count);

/* Starts a packet of `count` rays, and finishes it. `scene`: as for plt_packet_begin. */
void plt_packet_set_rays(plt_packet *packet, const plt_box *scene, const plt_ray *rays,
                         uint32_t count, int any);

/* The hits of a packet whose traversal is done, in the order of its `count` rays. */
void plt_packet_store(const plt_packet *packet, plt_hit *hits, uint32_t count);

#endif
