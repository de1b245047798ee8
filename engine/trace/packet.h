/* packet - up to 16 x 16 rays in groups of four
 *
 * Invariant: everything in a group depends on its rays and the scene's box
 * alone, never on the other groups; fields of the packet only say which short
 * cuts give the same numbers, and leave out nothing that a ray would hit
 * (frustum.h). So a ray's hit is the same in any packet.
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
#include "engine/trace/slabs.h"

/* A group: four rays and their hits, beside their slabs; [axis][lane]. 68 bytes per ray. */
typedef struct plt_group_rays {
    float org[3][4], dir[3][4];
    float slope[2][4];     /* shear towards the axis of the largest component */
    float reach[4];        /* largest distance on any axis from org to the scene's box */
    float least_slack[4];  /* of edge functions (triangle.c): 320 u^2 reach^2 */
    float u[4], v[4];      /* of the nearest hit, whose t is tmax of the slabs */
    uint32_t id[4];        /* its primitive id, PLT_MISS: none */
    float normal[3][4];    /* its normal, not normalised */
    uint8_t axis_lanes[3]; /* per axis, the lanes whose largest component it is */
    uint8_t valid;         /* lanes that hold a ray */
    uint8_t pad[12];       /* to a multiple of 16 */
} plt_group_rays;

_Static_assert(sizeof(plt_group_slabs) == 176 && sizeof(plt_group_rays) == 272,
               "112 bytes per ray, and both multiples of 16");

/* plt_packet.axis when rays differ in the axis of their largest component. */
#define PLT_AXES_DIFFER 3

typedef struct plt_packet {
    plt_slab_array slabs; /* of the groups */
    plt_group_rays *rays; /* [groups], in the arena */
    unsigned groups;
    plt_mask active; /* groups with a valid ray; any hit: with one that has hit nothing yet */
    uint8_t any;     /* any hit is enough */
    uint8_t axis;    /* of the largest component in all rays, or PLT_AXES_DIFFER */
    float org[3], reach, least_slack; /* PLT_ONE_ORIGIN: as in the groups */
    float forward[3];                 /* sum of the directions of first lanes */
} plt_packet;

/* Bytes of slabs and rays of a packet of side^2 rays. */
static inline size_t plt_packet_bytes(unsigned side) {
    return (size_t)side * side / 4 * (sizeof(plt_group_slabs) + sizeof(plt_group_rays));
}

/* Lays slabs and rays out in `memory`, plt_packet_bytes(side) of it. */
void plt_packet_init(plt_packet *packet, void *memory, unsigned side);

/* Starts a packet of `groups` groups; when all of them are set, finish finds its
 * short cuts. */
void plt_packet_begin(plt_packet *packet, unsigned groups, int any);
void plt_packet_finish(plt_packet *packet);

/* Turns 4 rays into group `index`; lanes from `count` on stay without a ray. `scene`:
 * the box of all that may be hit. */
void plt_packet_set_group(plt_packet *packet, unsigned index, const plt_box *scene, const f4 org[3],
                          const f4 dir[3], f4 tmin, f4 tmax, unsigned count);

#endif
