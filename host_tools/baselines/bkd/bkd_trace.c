/* bkd_trace - see bkd_trace.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/bkd/bkd_trace.h"

#include "host_tools/baselines/bkd/bkd_tree.h"

#define PLANES_OUTER 1

static inline uint32_t planes_node_root(const void *nodes) {
    const bkd_tree *b = nodes;
    return b->root;
}

static inline int planes_node_is_leaf(const void *nodes, uint32_t link) {
    return bkd_is_leaf(nodes, link);
}

static inline uint32_t planes_node_leaf(const void *nodes, uint32_t link) {
    return bkd_leaf_record(nodes, link);
}

static inline planes_view planes_node_view(const void *nodes, uint32_t link) {
    return bkd_view(nodes, link);
}

/* The traversals themselves. */
#include "host_tools/baselines/planes/planes_lone.h"
#include "host_tools/baselines/planes/planes_packet.h"

void bkd_trace_lone(planes_tracing *t, lone_ray *r) {
    planes_trace_lone(t, r);
}

void bkd_trace_packet(planes_tracing *t) {
    planes_trace_packet(t);
}
