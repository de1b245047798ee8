/* rays - from an array of rays to an array of hits
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_RAYS_H
#define PLT_TRACE_RAYS_H

#include "engine/trace/packet_rays.h"
#include "engine/trace/traversal.h"

/* Traces `count` rays, at most those of `packet`, of side^2 rays. PLT_OK, or what a
 * fetch failed with: then the hits are left as they were. */
int plt_trace_packet(plt_traversal *t, plt_packet *packet, const plt_ray *rays, plt_hit *hits,
                     uint32_t count, int any);

#endif
