/* hulls - a packet as a tree: four lanes, each the interval hull of some rays
 *
 * Four rays are a group, four groups a lane of a hull each, and so on up to the packet, so one
 * test of a box against four lanes serves at whatever level suits the box: near the root of
 * the scene a lane stands for a quarter of the packet, at the leaves for four rays. Every test
 * that packets had before (first active ray, frustum, masks) is a special case of it.
 *
 * Distances here are depths: along the axis that is the largest of every ray's direction, in
 * scene units, t * |dir[axis]|. A lane's depth of entry is at most that of any of its rays,
 * and its depth of exit at least: what a ray of it may hit is never left out (DESIGN.md,
 * section 7.8). Which boxes are opened changes no hit (triangle.h).
 *
 * Sources: Reshetov, Soupikov, Hurley, "Multi-level ray tracing algorithm", 2005 (interval
 * arithmetic over a beam); Karrenberg 2007, section 3.5.2, which it generalises.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_HULLS_H
#define PLT_TRACE_HULLS_H

#include "engine/trace/packet.h"

/* Four lanes; [axis][lane]. A lane without a ray has least > most. 304 bytes. */
struct plt_hull {
    /* As a group has them, of depths: rdir is the depth that a ray goes for each step
     * of 1 along an axis, signed as its direction, the least of the lane's rays (along the
     * packet's axis 1 or -1); the origins furthest along and furthest back; and the depths
     * between which any of the rays seeks a hit. */
    plt_group_slabs slabs;
    float far_rate[3][4]; /* as rdir, the greatest */
    /* PLT_MIXED: rdir belongs to lower planes, 0 where no ray runs up; this to upper ones, 0
     * where none runs down. far_rate is 0 where there are both. */
    float back_rate[3][4];
    float narrow[2][4]; /* what is shorter than narrow[0] * depth + narrow[1] is small beside the
                           lane */
};

/* Hulls are numbered from 0, the packet, downwards: below lane j of hull k lies hull
 * 4 k + 1 + j, or from plt_packet.first_group on a group. */
static inline unsigned plt_hull_below(unsigned hull, unsigned lane) {
    return 4 * hull + 1 + lane;
}

/* Sets up the hulls of a packet that can have them (packet->along), once it is finished. */
void plt_hulls_set(plt_packet *packet);

/* Hits have changed tmax in the groups of packet->changed: brings the hulls up to date. */
void plt_hulls_narrow(plt_packet *packet);

#endif
