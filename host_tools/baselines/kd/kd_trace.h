/* kd_trace - single rays through a kd-tree, cells near the origin first
 *
 * A ray visits the cells within 3 e of it (lone_ray.h), as long as they begin no farther than the
 * hit it has. A hit that is reported at q is thus found: q lies in a cell, or at most 1.5 e outside
 * all of them, whose triangles include it (kd_stray.h), and for every plane above that cell the ray
 * goes to its side by t.
 *
 * Source: Wald, "Realtime ray tracing and interactive global illumination", 2004, section 7;
 * Amanatides, Woo, 1987 (the mailbox).
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_KD_TRACE_H
#define BASELINES_KD_TRACE_H

#include "host_tools/baselines/base/lone_ray.h"
#include "host_tools/baselines/kd/kd_build.h"
#include "host_tools/baselines/packet/packet_counts.h"

typedef struct kd_counts {
    uint64_t visits, planes, tests, sieved;
} kd_counts;

typedef struct kd_tracing {
    kd_tree *tree; /* nodes that are not split yet are */
    const kd_scene *scene;
    uint32_t *mailbox; /* of each triangle the last ray that was tested; none is `number` */
    uint32_t number;   /* of the ray, from 1 */
    int any;
    kd_counts counts;
    packet_counts packets; /* that go together, as the thesis counts them */
} kd_tracing;

enum { KD_STACK = 64 }; /* levels are at most 8 + 1.3 * 27 (kd_cell.c) */

/* Whether the ray comes from farther off than cells with strays are for (kd_stray.h). */
static inline int kd_is_far(const kd_scene *s, const lone_ray *r) {
    return s->plane != NULL && r->origin.reach > s->reach;
}

/* -1: no memory to split a node. */
int kd_trace(kd_tracing *k, lone_ray *r);

#endif
