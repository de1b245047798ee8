/* packet_quick - groups set up by lanes that flush subnormals, if there are none
 *
 * What packet_set.c does, with the same bits, or nothing that counts: then it does it itself
 * (DESIGN.md, section 8.2). No lanes pass between the two, as theirs are others.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_PACKET_QUICK_H
#define PLT_TRACE_PACKET_QUICK_H

#include "engine/trace/packet.h"

#define PLT_QUICK_LANES (PLT_LANES_FLUSHES && !PLT_WITH_HULLS)

#if PLT_QUICK_LANES
/* Of a group that has four rays' org, dir, tmin and tmax as they were given; `has_rays`: one is
 * valid. 0: a subnormal was flushed, and the group holds nothing. */
int plt_packet_set_quickly(plt_packet *packet, unsigned index, unsigned count, int *has_rays);

/* What groups have in common with the packet's ray; nothing, if a subnormal was flushed. */
void plt_packet_compare_quickly(const plt_packet *packet, plt_common *common);
#endif

#endif
