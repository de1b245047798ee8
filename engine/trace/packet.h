/* packet - up to 16 x 16 rays in groups of four
 *
 * Invariant: everything in a group depends on its rays and the scene's box
 * alone, never on the other groups; flags of the packet only say which short
 * cuts give the same numbers, and leave out nothing that a ray would hit (rim.h).
 * So a ray's hit is the same in any packet.
 *
 * Source: Karrenberg 2007, section 3.5 (packets, masks, equal signs).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_PACKET_H
#define PLT_TRACE_PACKET_H

#include "engine/base/box.h"
#include "engine/lanes/lanes.h"
#include "engine/planelet.h"
#include "engine/trace/mask.h"

/* Four rays; [axis][lane]. Lanes without a valid ray have tmin > tmax. */
typedef struct plt_group {
    float rdir[3][4];       /* 1 / dir, finite: tiny components are made 2^-60 of the largest */
    float tmin[4], tmax[4]; /* tmax shrinks to the nearest hit; any hit: -1 */
    float near_org[3][4];   /* org moved so that a near plane comes no later ... */
    float far_org[3][4];    /* ... and a far plane no earlier than for any hit */
    float org[3][4], dir[3][4];
    float slope[2][4];    /* shear towards the axis of the largest component */
    float reach[4];       /* to the scene's box, on any axis: at least to every corner */
    float reach_error[4]; /* 320 u^2 reach^2 */
    float u[4], v[4];
    uint32_t source[4];    /* number of the nearest hit, PLT_MISS: none */
    float normal[3][4];    /* its normal, not of unit length */
    uint8_t axis_lanes[3]; /* lanes whose largest component is that axis */
    uint8_t valid;         /* lanes that hold a ray */
    uint8_t pad[12];       /* to a multiple of 16 */
} plt_group;

typedef struct plt_packet {
    plt_group *group; /* in the arena */
    unsigned groups;
    plt_mask active;                       /* groups with a valid ray; any hit: that still seeks */
    uint8_t any;                           /* any hit is enough */
    uint8_t mixed;                         /* rays differ in a direction sign */
    uint8_t shared;                        /* all rays start at one point */
    uint8_t negative[3];                   /* sign by axis, unless mixed */
    uint8_t axis;                          /* of the largest component in all rays; 3: differs */
    float near_org[3], far_org[3], org[3]; /* if shared */
    float reach, reach_error;              /* if shared: as in the groups */
    float forward[3];                      /* roughly where the packet goes */
} plt_packet;

/* Turns 4 rays into group `index`; lanes from `count` on stay without a ray. */
void plt_group_set(plt_packet *packet, unsigned index, const plt_box *scene, const f4 org[3],
                   const f4 dir[3], f4 tmin, f4 tmax, unsigned count);

/* Starts a packet of `groups` groups, then finds its short cuts when all
 * groups are set. */
void plt_packet_begin(plt_packet *packet, unsigned groups, int any);
void plt_packet_finish(plt_packet *packet);

#endif
