/* instances_state - what a traversal of instances keeps from visit to visit
 *
 * Inside a body goes a traversal of its own, over a scene of that body alone, with a packet of its
 * own: the same rays, as the body sees them.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_INSTANCES_STATE_H
#define PLT_TRACE_INSTANCES_STATE_H

#include "engine/trace/treelet_entry.h"

/* An instance or a node of the top tree that is to be visited. */
typedef struct plt_top_entry {
    uint32_t child;
    uint32_t parent; /* the node that it is a child of, times two, and which child; or PLT_MISS */
    plt_mask groups;
} plt_top_entry;

typedef struct plt_instances_state {
    plt_traversal inner;
    plt_packet packet; /* its memory is a part of the arena */
    plt_scene body;    /* the one that is visited */
    plt_treelet_state treelet;
    uint32_t instance; /* that is visited, if is_inside */
    plt_mask visited;  /* groups that went there */
    uint8_t is_inside;
    uint32_t waiting;
    plt_top_entry entry[PLT_TOP_DEPTH + 1];
} plt_instances_state;

static inline plt_instances_state *plt_instances_state_of(const plt_traversal *t) {
    return (plt_instances_state *)t->state;
}

#endif
