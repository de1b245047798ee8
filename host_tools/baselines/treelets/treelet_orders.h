/* treelet_orders - the orders in which a packet can traverse a tree in treelets
 *
 * TREELET_FIGURE is the thesis's, exactly as Figure 4.2 has it: nodes of the treelet in hand wait
 * on a local stack, the left child pushed first, edges that leave it and leaves on a global one, as
 * they come. Nothing is ordered, and what comes off a stack is not tested again. The text of 4.2
 * does not agree with it, if left is near (3.5.4): there the last edge comes from the far side.
 * Those have orders of their own. The others push the farther child first. By default all but
 * those three hold what comes off a stack against its box again, as hits may hide it by now.
 *
 * Counted are visits: a packet at a node, whose children are tested.
 *
 * Sources: Karrenberg 2007, sections 3.5.4, 4.2, 4.3, 8.2.4 and Figure 4.2.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_TREELET_ORDERS_H
#define BASELINES_TREELET_ORDERS_H

#include "host_tools/baselines/packet/packet_state.h"
#include "host_tools/baselines/treelets/treelet_nodes.h"
#include "host_tools/baselines/treelets/treelet_stack.h"

enum treelet_order {
    TREELET_FIGURE,
    TREELET_TEXT,       /* the nearer child of a node first, so that far edges are on top */
    TREELET_MIRRORED,   /* the farther one first, so that near edges are */
    TREELET_SORTED,     /* the edges of a treelet, nearest on top of the global stack (8.2.4) */
    TREELET_LEAF_FIRST, /* likewise, leaves on top of nodes (4.3) */
    TREELET_HEAP,       /* of all edges that wait the nearest is next (8.2.4) */
    TREELET_DEPTH,      /* depth first across treelets; an entry names treelet and node */
    TREELET_ORDERS
};

typedef struct treelet_tracing {
    const treelet_nodes *nodes;
    packet_state *packet;
    enum treelet_order order;
    uint8_t tests_again; /* what comes off a stack */
    treelet_stack global, local;
    uint64_t entered; /* treelets, each time */
} treelet_tracing;

/* The packet has begun. -1: no memory for a stack; hits are not all found. */
int treelet_trace(treelet_tracing *t);
/* Packets one after the other, of a tree with triangles. -1: likewise. */
int treelet_trace_packets(treelet_tracing *t, const plt_ray *rays, plt_hit *hits, uint32_t count,
                          int any);
void treelet_tracing_free(treelet_tracing *t);

#endif
