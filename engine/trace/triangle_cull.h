/* triangle_cull - groups that a triangle surely misses, by lanes that flush subnormals
 *
 * Leaves out nothing that a ray would hit (DESIGN.md, section 8.2).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRIANGLE_CULL_H
#define PLT_TRACE_TRIANGLE_CULL_H

#include "engine/trace/packet.h"
#include "engine/trace/triangle_corners.h"

#if PLT_LANES_FLUSHES
/* Of `groups` those that the triangle may cover. */
plt_mask plt_triangle_may_meet(const plt_packet *packet, const plt_triangle *triangle,
                               plt_mask groups);
#endif

#endif
