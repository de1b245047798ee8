/* packet_plain - packets of rays that are much alike, at a glance
 *
 * Most packets of a file have four rays in every group, none that is no ray, and one axis along
 * which all directions are largest, whichever they are between the least and the greatest of each
 * component. Of such rays nothing has to be asked one by one, nor has it to be compared: what
 * packet.h finds out group by group follows from the extents.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_PACKET_PLAIN_H
#define PLT_TRACE_PACKET_PLAIN_H

#include "engine/trace/packet.h"

/* Sets up a packet that was begun, and finishes it, if its rays are plain; 0: they are not, and
 * nothing was done. Bit for bit as plt_packet_set_group and plt_packet_finish set it up, but for
 * `forward`. */
int plt_packet_set_plain(plt_packet *packet, const plt_ray *rays, uint32_t count);

#endif
