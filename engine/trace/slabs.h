/* slabs - the part of four rays that a box test needs
 *
 * Four rays are a group; this is what boxes.h reads of it. Hits, and what only the
 * ray/triangle test needs, are apart, in packet.h. So something that is no ray can be
 * tested against boxes by the same arithmetic: a beam, the interval hull of rays, has one
 * of these that bounds where it enters boxes and one that bounds where it leaves them.
 *
 * Source: Kay and Kajiya, "Ray tracing complex scenes", 1986.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_SLABS_H
#define PLT_TRACE_SLABS_H

#include <stdint.h>

/* [axis][lane]. A lane without a valid ray has tmin > tmax. 176 bytes, 44 per ray. */
typedef struct plt_group_slabs {
    float rdir[3][4];       /* 1 / dir, finite: tiny components are made 2^-60 of the largest */
    float near_org[3][4];   /* org shifted by the rounding bound: entries are never too late ... */
    float far_org[3][4];    /* ... and exits never too early */
    float tmin[4], tmax[4]; /* tmax shrinks to the nearest hit; any hit: -1 */
} plt_group_slabs;

/* What all rays of a packet have in common decides how a box is tested; all three give
 * the same numbers, bit for bit. */
enum plt_coherence {
    PLT_ONE_ORIGIN, /* one origin and equal signs: plane - origin once per box and packet */
    PLT_ONE_SIGN,   /* equal signs: near and far planes are chosen once per box and packet */
    PLT_MIXED       /* nothing: planes are chosen lane by lane */
};

/* The slabs of a packet's groups, and what all of them have in common. */
typedef struct plt_slab_array {
    plt_group_slabs *group;        /* in the arena */
    float near_org[4], far_org[4]; /* PLT_ONE_ORIGIN: as in all groups; the fourth is 0 */
    uint32_t backwards[4];         /* unless PLT_MIXED: all ones on axes of negative directions */
    uint8_t negative[3];           /* the same, 1 each */
    uint8_t coherence;             /* enum plt_coherence */
} plt_slab_array;

#endif
