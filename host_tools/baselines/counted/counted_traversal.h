/* counted_traversal - the engine's own traversal of thesis nodes, which says what packets met
 *
 * The engine's orders (order_hulls.h, order_depth_first.h, order_two_stage.h) over the engine's
 * format, compiled once more with a tally where they look at a node and at a leaf. So nothing is
 * counted where nobody asks: the engine itself has no such code, nor has a firmware.
 *
 * A packet meets a node when it is held against its planes, and a triangle when it is held against
 * that, once each, however many of its hulls are, one after the other. Its rays that are active
 * there are those of all those hulls together: of a hull of rays all that it stands for, of a group
 * at a node the lanes that met its box, and at a triangle the whole group, which is tested at once.
 *
 * Source: Karrenberg 2007, section 5.4, Table 5.4.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_COUNTED_TRAVERSAL_H
#define BASELINES_COUNTED_TRAVERSAL_H

#include "engine/shade/camera.h"
#include "engine/trace/traversal.h"
#include "host_tools/baselines/packet/packet_counts.h"
#include "host_tools/baselines/packet/packet_mask.h"

/* A node or a triangle that the packet has met, and its rays there. */
typedef struct counted_met {
    uint32_t index;
    packet_mask rays;
} counted_met;

/* A set of those: place[i] is where met has i, if it has it. */
typedef struct counted_set {
    uint32_t *place;  /* owned; anything may be in it */
    counted_met *met; /* owned */
    uint32_t count, room;
} counted_set;

/* Over a scene of resident thesis nodes; nothing else may use the engine's arena meanwhile. All
 * zero: nothing is counted yet. */
typedef struct counted_traversal {
    plt_traversal t; /* a copy of the engine's, with statistics of its own */
    counted_set nodes, triangles;
    packet_counts counts; /* of the thesis; group_tests and what follows it are not set */
} counted_traversal;

/* As the engine's traversal is now, with room for what its tree has now. -1: no memory. */
int counted_begin(counted_traversal *c, const plt_traversal *t);
void counted_close(counted_traversal *c);

/* As plt_trace_packet, with the same hits, visits and tests. */
void counted_trace(counted_traversal *c, plt_packet *p, const plt_ray *rays, plt_hit *hits,
                   uint32_t count, int any);

/* The rays of a square of pixels, as a frame has them. */
void counted_square(counted_traversal *c, plt_packet *p, const plt_view *view,
                    const plt_pixels *pixels);

#endif
