/* triangle - a packet's groups against a triangle, watertight
 *
 * A ray that meets a triangle, edges and corners included, is never turned
 * away: three edge functions in single precision decide where their error
 * bounds allow, and close calls go to exact.h, which is never wrong. So no ray
 * slips through an edge or a corner of a closed mesh. t comes from the
 * triangle's plane and is held within the triangle's own box, which a ray
 * must meet: hence a hit lies in every box around its triangle, and no tree,
 * packet or order of visits can change it. Of equal t the lower source number
 * wins. A triangle without area has no inside and is never hit.
 *
 * Sources: Woop, Benthin, Wald, "Watertight ray/triangle intersection", 2013
 * (the shear and the edge functions). Error bounds, pairs of floats instead of
 * their double precision, and the clamp are ours (DESIGN.md, section 7).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRIANGLE_H
#define PLT_TRACE_TRIANGLE_H

#include "engine/trace/packet.h"
#include "engine/tree/record.h"

/* Tests record number `number` for `groups`; records hits in the groups. No side
 * of the triangle's box is longer than `longest`. For any-hit packets, groups
 * whose rays have all hit leave packet->active. */
void plt_triangle_groups(plt_packet *packet, const plt_record *record, uint32_t number,
                         float longest, plt_mask groups);

/* The normal, not of unit length: (p1 - p0) x (p2 - p0). */
void plt_record_normal(const plt_record *record, float normal[3]);

#endif
