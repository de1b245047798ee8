/* triangle - a packet's groups against a triangle, watertight
 *
 * The corners are sheared so that the ray runs along an axis through 0, 0;
 * three 2-D edge functions then decide. Each is the exact negative of the one
 * that the neighbour across the edge computes and never has the wrong sign, so
 * that no ray slips through an edge or a corner of a closed mesh. t comes from
 * the triangle's plane and is held within the triangle's own box, which a ray
 * must meet: hence a hit lies in every box around its triangle, and no tree,
 * packet or order of visits can change it. Of equal t the lower source number
 * wins. A triangle whose computed normal is 0 is never hit.
 *
 * Sources: Woop, Benthin, Wald, "Watertight ray/triangle intersection", 2013
 * (shear and edge functions; zero counts as inside on both sides, instead of
 * their double precision). The clamp to the box is ours (DESIGN.md, section 7).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRIANGLE_H
#define PLT_TRACE_TRIANGLE_H

#include "engine/trace/packet.h"
#include "engine/tree/record.h"

/* Tests record number `number` for `groups`; records hits in the groups. For
 * any-hit packets, groups whose rays have all hit leave packet->active. */
void plt_triangle_groups(plt_packet *packet, const plt_record *record, uint32_t number,
                         plt_mask groups);

/* The normal, not of unit length: (p1 - p0) x (p2 - p0). */
void plt_record_normal(const plt_record *record, float normal[3]);

#endif
