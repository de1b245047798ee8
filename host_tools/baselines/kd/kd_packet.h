/* kd_packet - up to 64 rays through a kd-tree together
 *
 * A node is visited when a ray has a part in it; each ray keeps its own (kd_trace.h says which).
 * Rays of a packet point to the same side along every axis, so that they have the same child first.
 * A triangle is tested for each ray once: what has been is a mask.
 *
 * Source: Wald, Slusallek, Benthin, Wagner, "Interactive rendering with coherent ray tracing",
 * 2001.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_KD_PACKET_H
#define BASELINES_KD_PACKET_H

#include "host_tools/baselines/kd/kd_trace.h"

enum { KD_PACKET = 64 };

/* What is left of the rays in a node; empty where from > to. */
typedef struct kd_parts {
    uint32_t node;
    float from[KD_PACKET], to[KD_PACKET];
} kd_parts;

typedef struct kd_packet {
    lone_ray ray[KD_PACKET];
    uint32_t count;
    float early[3][KD_PACKET], late[3][KD_PACKET], rdir[3][KD_PACKET]; /* of the rays */
    float limit[KD_PACKET]; /* their tmax; below 0: one that wants no more */
    kd_parts stack[KD_STACK];
} kd_packet;

/* Whether the rays, at least one, can go together. */
int kd_packet_fits(const kd_packet *p, const kd_scene *s);

/* `tested`: of each triangle the rays, valid where the mailbox has the packet's number. -1: no
 * memory to split a node. */
int kd_packet_trace(kd_packet *p, kd_tracing *k, uint64_t *tested);

#endif
