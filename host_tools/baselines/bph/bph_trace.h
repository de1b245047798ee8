/* bph_trace - packets through a BPH as the thesis traverses it, with every one of its switches
 *
 * Both children are met in one pass, by intervals that each ray keeps in the node, and on the stack
 * (3.5); or their boxes are reconstructed and tested as boxes. What waits is looked at again when
 * hits have come meanwhile.
 *
 * Early hits (8.1.1): the stack has the box, too. A child whose box the first active ray hits is
 * entered at once, and its entry is incomplete: what it has of other rays are those of its parent.
 * Where rays have to be tested one by one below it, a child's box is reconstructed and tested as a
 * whole, and the entry is complete again. Where the entry was complete both children are met in one
 * pass, and so a child that was entered early comes out complete, too.
 *
 * Source: Karrenberg 2007, sections 3.5, 6.3 and 8.1.1, figures 3.7 and 8.1.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BPH_TRACE_H
#define BASELINES_BPH_TRACE_H

#include "host_tools/baselines/bph/bph_planes.h"
#include "host_tools/baselines/bph/bph_switches.h"
#include "host_tools/baselines/packet/packet_counts.h"

typedef struct bph_entry {
    bph_edge edge;
    plt_box box;   /* where boxes are kept: naive, early hits, a frustum */
    bph_set rays;  /* that go on here */
    uint64_t hits; /* of the tracing, when it was made */
    float nearest; /* where the first ray that is known to hit enters */
    uint8_t is_incomplete;
    bph_intervals at; /* of those rays, unless it is incomplete or naive */
} bph_entry;

/* What the thesis counts is in packet_counts.h; this is what its switches save, or take. */
typedef struct bph_tally {
    uint64_t distances; /* ray and plane */
    uint64_t matches;   /* of a plane with the side that a child has it on */
    uint64_t tests;     /* ray and triangle */
    uint64_t early_tests, early_hits;
    uint64_t frustum_tests, frustum_exits;
    uint64_t reconstructions; /* of a child's box below an incomplete entry */
    uint64_t recomputed;      /* boxes of an intermediate node's lists */
} bph_tally;

typedef struct bph_tracing {
    const bph_tree *tree;
    bph_way way;
    bph_packet packet;
    bph_entry *stack; /* bph_trace_entries of them */
    bph_entry child[2];
    uint64_t hits;
    int any;
    packet_counts counts; /* nodes, triangles, packets and their signs */
    bph_tally tally;
} bph_tracing;

static inline uint64_t bph_trace_entries(const bph_tree *t) {
    return (uint64_t)t->levels + 2;
}

/* What of an entry is kept between nodes, in bytes, for packets of so many rays. */
uint32_t bph_trace_entry_bytes(const bph_way *way, uint32_t rays);

/* The rays of the packet, which is begun, at least one; of a tree with triangles. */
void bph_trace(bph_tracing *t);

#endif
