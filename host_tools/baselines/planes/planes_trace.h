/* planes_trace - what rays take through a tree of one axis per node, and what is counted
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_PLANES_TRACE_H
#define BASELINES_PLANES_TRACE_H

#include "host_tools/baselines/base/binary_tree.h"
#include "host_tools/baselines/base/lone_ray.h"
#include "host_tools/baselines/packet/packet_box.h"

/* At a link one child waits at every level; the other one is gone on with. */
enum { PLANES_DEPTH = BINARY_DEPTH + 2 };

typedef struct planes_counts {
    uint64_t visits, planes, tests; /* nodes and leaves; planes; triangles: of lone rays */
    uint64_t leaves;                /* that packets came to */
} planes_counts;

/* A place of the stack: what is left of a packet at a link. */
typedef struct planes_rest {
    uint32_t link;
    packet_mask in;                                     /* rays that have something left */
    float from[PACKET_GROUPS][4], to[PACKET_GROUPS][4]; /* of the groups of `in` */
} planes_rest;

/* Likewise, where the box that the planes have left of the scene's is kept instead. */
typedef struct planes_room {
    uint32_t link;
    packet_range range;
    packet_mask in;
    plt_box box;
} planes_room;

/* How packets go: by what is left of each ray, or of the scene's box. */
typedef struct planes_way {
    uint8_t boxes; /* 1: the latter; then: */
    uint8_t bits;  /* 1: a mask of all rays; 0: groups from the first to the last */
    packet_steps steps;
} planes_way;

typedef struct planes_tracing {
    const void *nodes; /* a tree of the layout */
    const plt_record *record;
    plt_box box;   /* of all records */
    float longest; /* at least the longest side of any's box */
    int any;
    planes_counts counts;
    planes_way way;
    packet_state packet; /* not open: rays go one by one */
    planes_rest *rest;   /* PLANES_DEPTH, of those that go by it; or NULL */
    planes_room *room;   /* likewise */
} planes_tracing;

/* A leaf's records against a ray. */
static inline void planes_leaf_meet(planes_tracing *t, lone_ray *r, uint32_t first) {
    const plt_record *at = t->record + first;
    t->counts.visits++;
    do {
        t->counts.tests++;
        lone_ray_meet(r, at);
    } while (!plt_record_is_last(at++));
}

#endif
