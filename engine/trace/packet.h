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
    float slope[2][4]; /* shear towards the axis of the largest component */
    float reach[4];    /* largest distance on any axis from org to the scene's box */
#if PLT_WITH_HULLS
    union { /* of the nearest hit, whose t is tmax of the slabs */
        struct {
            float u[4], v[4];
        };
        float normal[3][4]; /* plt_packet.surfaces: its normal, not normalised */
    };
#else
    float least_slack[4]; /* of edge functions (triangle.c): 320 u^2 reach^2 */
    float u[4], v[4];     /* of the nearest hit, whose t is tmax of the slabs */
    float normal[3][4];   /* its normal, not normalised */
#endif
    uint32_t id[4];        /* its primitive id, PLT_MISS: none */
    uint8_t axis_lanes[3]; /* per axis, the lanes whose largest component it is */
    uint8_t valid;         /* lanes that hold a ray */
    uint8_t pad[12];       /* to a multiple of 16 */
} plt_group_rays;

_Static_assert(sizeof(plt_group_slabs) == 176 &&
                   sizeof(plt_group_rays) == (PLT_WITH_HULLS ? 224 : 272),
               "100 or 112 bytes per ray, and both multiples of 16");

/* plt_packet.axis when rays differ in the axis of their largest component. */
#define PLT_AXES_DIFFER 3

typedef struct plt_hull plt_hull; /* hulls.h */

typedef struct plt_packet {
    plt_slab_array slabs; /* of the groups */
    plt_group_rays *rays; /* [groups], in the arena */
    const plt_box *scene; /* the box of all that may be hit */
    unsigned groups;
    plt_mask active; /* groups with a valid ray; any hit: with one that has hit nothing yet */
    uint8_t any;     /* any hit is enough */
    uint8_t axis;    /* of the largest component in all rays, or PLT_AXES_DIFFER */
    float org[4];    /* PLT_ONE_ORIGIN: as in the groups; 0 */
    float reach, least_slack; /* the largest of all groups */
    float forward[4];         /* sum of the directions of first lanes; 0 */
#if PLT_WITH_HULLS
    plt_hull *hull;                 /* [plt_hull_count(side)], in the arena */
    unsigned first_group, capacity; /* hulls before the first group; groups that fit */
    plt_mask ready;                 /* groups whose reach and slabs are set */
    plt_mask changed;               /* groups with hits that the hulls do not know yet */
    float least_sure;               /* of edge functions: 128 u reach times how far origins move */
    uint8_t surfaces;               /* hits have normals, or 0: u and v */
    uint8_t unbounded;              /* all groups seek hits from 0 on, without an end; 0: unknown */
    uint8_t along;                  /* hulls can be set: one axis, one direction along it */
    uint8_t moved;   /* hulls of one origin, which is moved for all: groups need rates alone */
    float across[4]; /* 1 on the two axes across the packet's, else 0 */
#endif
} plt_packet;

/* Hulls of a packet of side^2 rays, and levels that they have. */
static inline size_t plt_hull_count(unsigned side) {
    return PLT_WITH_HULLS ? (side * side / 4 - 1) / 3 : 0;
}

static inline unsigned plt_hull_levels(unsigned side) {
    return side >= 16 ? 3 : side / 4; /* 2, 4, 8, 16 to 0, 1, 2, 3 */
}

enum { PLT_HULL_BYTES = 304 };

/* Bytes of slabs, rays and hulls of a packet of side^2 rays. */
static inline size_t plt_packet_bytes(unsigned side) {
    return (size_t)side * side / 4 * (sizeof(plt_group_slabs) + sizeof(plt_group_rays)) +
           plt_hull_count(side) * PLT_HULL_BYTES;
}

/* Lays slabs and rays out in `memory`, plt_packet_bytes(side) of it. */
void plt_packet_init(plt_packet *packet, void *memory, unsigned side);

/* Starts a packet of `groups` groups; when all of them are set, finish finds its
 * short cuts. `scene`: the box of all that may be hit; it must stay where it is. */
void plt_packet_begin(plt_packet *packet, const plt_box *scene, unsigned groups, int any);
void plt_packet_finish(plt_packet *packet);

/* After plt_packet_begin: hits are to have normals. Without it u and v are sure, and where there
 * are hulls normals are not there, or the other way round. */
static inline void plt_packet_want_normals(plt_packet *packet) {
#if PLT_WITH_HULLS
    packet->surfaces = 1;
#else
    (void)packet;
#endif
}

/* The other way round: u and v, and where there are hulls no normals. */
static inline void plt_packet_want_weights(plt_packet *packet) {
#if PLT_WITH_HULLS
    packet->surfaces = 0;
#else
    (void)packet;
#endif
}

/* Turns 4 rays into group `index`; lanes from `count` on stay without a ray. */
void plt_packet_set_group(plt_packet *packet, unsigned index, const f4 org[3], const f4 dir[3],
                          f4 tmin, f4 tmax, unsigned count);

/* What groups have in common with the ray that was copied, and the sum of their directions. */
typedef struct plt_common {
    unsigned is_apart;      /* 0: all have its origin */
    unsigned axes;          /* a bit per axis that is the largest of some ray */
    unsigned other_sign[3]; /* lanes that run the other way along an axis */
    float forward[3];       /* of first lanes */
} plt_common;

#if PLT_WITH_HULLS
/* Instead of plt_packet_finish where that is known, and all groups have four rays. */
void plt_packet_share(plt_packet *packet, const plt_common *common);

/* Bounds for all rays: none has a larger reach, or an origin further from 0 on any axis. */
void plt_packet_set_reach(plt_packet *packet, float reach, float furthest);

/* A group's reach and slabs, which few groups of a packet with hulls need, are set when they
 * are asked for; without hulls, with the group. */
void plt_group_set_slabs(plt_packet *packet, unsigned index);

static inline void plt_group_make_ready(plt_packet *packet, unsigned index) {
    if ((packet->ready >> index & 1u) == 0) {
        plt_group_set_slabs(packet, index);
    }
}

/* The same for all groups with rays, for orders that test them against boxes one by one. */
void plt_packet_make_ready(plt_packet *packet);
#else
static inline void plt_group_make_ready(const plt_packet *packet, unsigned index) {
    (void)packet;
    (void)index;
}

static inline void plt_packet_make_ready(const plt_packet *packet) {
    (void)packet;
}
#endif

#endif
