/* wave_ray - a ray in flight, and its nearest hit so far
 *
 * Everything in it depends on the ray and the scene's box alone, by the arithmetic of
 * packet.c.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WAVE_RAY_H
#define PLT_TRACE_WAVE_RAY_H

#include <stdint.h>

/* A ray in flight; its stack follows. What every box needs is in all four lanes already. In
 * the ray's own axes the one of its largest component is last. 256 bytes, at a multiple of
 * 16. */
typedef struct plt_wave_ray {
    float near_org[3][4], far_org[3][4], rdir[3][4]; /* [axis], as in slabs.h */
    float tmin[4], tmax[4];  /* tmax: of the nearest hit so far; any hit: -1 */
    float org[3], reach;     /* in its own axes */
    float slope[2];          /* shear towards the last of its axes */
    float least_slack;       /* of edge functions: 320 u^2 reach^2 */
    float slack_per_length;  /* 72 u reach */
    float along;             /* the largest component of dir */
    uint32_t id;             /* of the nearest hit, PLT_MISS: none */
    float u, v;              /* of it */
    uint32_t number;         /* of the ray, in the array */
    uint32_t link;           /* what is next */
    uint32_t top;            /* entries on the stack */
    uint8_t near[3], far[3]; /* where near and far planes are in a plt_bvh4_node, in bytes */
    uint8_t axis[3];         /* its own axes, times 16 */
    uint8_t pad[11];
} plt_wave_ray;

_Static_assert(sizeof(plt_wave_ray) == 256, "a multiple of 16");

#endif
