/* figure_42 - treelets traversed to the letter of the thesis's Figure 4.2
 *
 * The reference for Table 5.6. Packets go through a BPH whose nodes are in treelets: a global stack
 * has what leaves treelets, a local one the nodes within. Left and right children are pushed as
 * they come, so the last edge is taken first, and nothing is sorted. What has waited is tested
 * against hits that have come meanwhile. (The figure does not say so; it saves 1 %.)
 *
 * The text says that packets go to the nearer child first (3.5.4), which the figure's order is not.
 * With near_last of a node's two edges the nearer one is pushed last, and of its two nodes the
 * nearer one first, so that its edges come later: the nearest edge mostly is on top.
 *
 * Source: Karrenberg 2007, section 4.2 and Figure 4.2.
 *
 * SPDX-License-Identifier: MIT */
#ifndef FIGURE_42_H
#define FIGURE_42_H

#include "host_tools/baselines/bph/bph_packet.h"
#include "host_tools/baselines/bph/bph_tree.h"
#include "host_tools/mesh/mesh.h"
#include "host_tools/treelets/forming.h"

enum { FIGURE_42_RAYS = 16 }; /* packets of 4x4 */

/* A node or lists that wait. */
typedef struct figure_42_entry {
    bph_edge edge;
    bph_set rays;
    float from[FIGURE_42_RAYS], to[FIGURE_42_RAYS];
} figure_42_entry;

typedef struct figure_42_stack {
    figure_42_entry *entry; /* owned */
    uint32_t count, room;
} figure_42_stack;

typedef struct figure_42 {
    bph_tree tree;         /* of spatial medians, one triangle per leaf */
    treelet_layout layout; /* of its nodes */
    int near_last;
    bph_packet packet;
    figure_42_stack global, local;
    int is_short; /* memory ran out: hits are not all there are */
    uint64_t packets, nodes, triangles;
} figure_42;

/* Treelets of `size` nodes, breadth first. -1: no memory, and nothing is open. */
int figure_42_open(figure_42 *t, const mesh *m, uint32_t size);
void figure_42_close(figure_42 *t);

/* As plt_trace, closest hits; `count` is a multiple of FIGURE_42_RAYS. -1: no memory. */
int figure_42_trace(figure_42 *t, const plt_ray *rays, plt_hit *hits, uint32_t count);

#endif
