/* slabs - the part of four rays that a box test needs
 *
 * Four rays are a group; this is what boxes.h reads of it. Hit data and what only the
 * ray/triangle test needs are apart, in packet.h, so that something that is no ray,
 * like the interval hull of a beam, can be tested against boxes as well.
 *
 * Source: Kay and Kajiya, "Ray tracing complex scenes", 1986.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_SLABS_H
#define PLT_TRACE_SLABS_H

#include <stdint.h>

/* [axis][lane]. A lane without a valid ray has tmin > tmax. 176 bytes, 44 per ray. */
typedef struct plt_slabs {
    float rdir[3][4];       /* 1 / dir, finite: tiny components are made 2^-60 of the largest */
    float near_org[3][4];   /* org moved so that a near plane comes no later ... */
    float far_org[3][4];    /* ... and a far plane no earlier than for any hit */
    float tmin[4], tmax[4]; /* tmax shrinks to the nearest hit; any hit: -1 */
} plt_slabs;

/* What all rays of a packet have in common decides how a box is tested; all three give
 * the same numbers, bit for bit. */
enum plt_coherence {
    PLT_ONE_ORIGIN, /* equal signs of direction and one origin: differences once per packet */
    PLT_ONE_SIGN,   /* equal signs: near and far planes are chosen once per packet */
    PLT_MIXED       /* nothing: planes are chosen lane by lane */
};

/* The slabs of a packet, or of anything else that is tested against boxes, and what they
 * have in common. */
typedef struct plt_slab_set {
    plt_slabs *group;              /* in the arena */
    float near_org[3], far_org[3]; /* PLT_ONE_ORIGIN: as in all groups */
    uint8_t negative[3];           /* direction sign per axis, unless PLT_MIXED */
    uint8_t coherence;             /* enum plt_coherence */
} plt_slab_set;

#endif
