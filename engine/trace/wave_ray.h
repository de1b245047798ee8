/* wave_ray - a ray in flight, and its nearest hit so far
 *
 * Everything in it depends on the ray and the scene's box alone, by the arithmetic of
 * packet_set.c.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WAVE_RAY_H
#define PLT_TRACE_WAVE_RAY_H

#include <stdint.h>

/* Where things of a ray are that depend on the signs of its direction and on the axis of its
 * largest component, in bytes. */
typedef struct plt_wave_offsets {
    uint8_t near[3], far[3]; /* near and far planes, in a plt_bvh4_node */
    uint8_t axis[3];         /* its own axes, in `org`; four times that, in a corner of a block */
} plt_wave_offsets;

/* A ray in flight; its stack follows. What every box needs is in all four lanes already. In
 * the ray's own axes the one of its largest component is last. The rest of the nearest hit so
 * far is in its place in the array of hits already. At a multiple of 16. */
typedef struct plt_wave_ray {
    float near_org[3][4], far_org[3][4], rdir[3][4]; /* [axis], as in slabs.h */
    float tmin[4], tmax[4]; /* tmax: of the nearest hit so far; any hit: -1 */
    float org[3], reach;
    float slope[2];    /* shear towards the last of its axes */
    float least_slack; /* of edge functions: 320 u^2 reach^2 */
    float along;       /* the largest component of dir */
    uintptr_t next;    /* what is next: wave_bvh4.c, wave_thesis.c */
    void *top;         /* its first free stack entry */
    uint32_t number;   /* of the ray, in the arrays */
    plt_wave_offsets at;
    uint8_t pad[19 - 2 * sizeof(void *)];
} plt_wave_ray;

_Static_assert(sizeof(plt_wave_ray) == 240, "a multiple of 16");

#endif
