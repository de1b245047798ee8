/* triangle - a packet's groups against a triangle, watertight
 *
 * A ray that meets a triangle, edges and corners included, is never turned away, and no
 * other is a hit: three edge functions in single precision decide where their error bounds
 * allow; cases within the error bound go to exact.h, which is never wrong. So no ray slips
 * through an edge or a corner of a closed mesh. t comes from the triangle's plane, in
 * integers where single precision would be mostly rounding, and is held
 * within the triangle's own box, which a ray must meet: hence a hit lies in every box around its
 * triangle, and no tree, packet or order of visits can change it. Of equal t the lower
 * primitive id wins. A triangle without area has no inside and is never hit.
 *
 * Sources: Woop, Benthin, Wald, "Watertight ray/triangle intersection", 2013
 * (the shear and the edge functions). Error bounds, integers instead of
 * their double precision, and the clamp are ours (DESIGN.md, section 7).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRIANGLE_H
#define PLT_TRACE_TRIANGLE_H

#include "engine/trace/packet.h"
#include "engine/trace/triangle_corners.h"
#include "engine/tree/primitive_id.h"

#if PLT_WITH_HULLS
/* The same in registers: x, y, z; the fourth lane means nothing, but should not be subnormal. */
typedef struct plt_triangle_rows {
    f4 corner[3];
    uint32_t word;
} plt_triangle_rows;

enum { PLT_TRIANGLES_MOST = 8 }; /* at a time */

/* Tests `count` triangles for groups, as plt_triangle_groups does each. */
void plt_triangles_groups(plt_packet *packet, const plt_triangle_rows *triangles, unsigned count,
                          const plt_primitive_ids *ids, float longest, plt_mask groups);
#endif

/* Tests a triangle for `groups`; records hits in the groups. For any-hit
 * packets, groups whose rays have all hit leave packet->active. */
void plt_triangle_groups(plt_packet *packet, const plt_triangle *triangle, plt_mask groups);

#endif
