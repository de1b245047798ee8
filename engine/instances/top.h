/* top - a small tree over the boxes of instances, made anew for every frame
 *
 * Of n instances n - 1 nodes, whose places are known beforehand: those of the first child of a node
 * follow it, and then come those of the second. Ranges are split by binned SAH on their longest
 * axis, and from PLT_TOP_SPLIT_LEVELS on in halves: so no path is longer than PLT_TOP_DEPTH.
 *
 * Source: Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007 (bins).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_INSTANCES_TOP_H
#define PLT_INSTANCES_TOP_H

#include "engine/instances/placed.h"

enum { PLT_TOP_SPLIT_LEVELS = 24, PLT_TOP_DEPTH = PLT_TOP_SPLIT_LEVELS + 17 };

#define PLT_TOP_LEAF 0x80000000u /* of a child: the rest is an instance, else a node */

typedef struct plt_top_node {
    plt_box box[2];
    uint32_t child[2];
} plt_top_node;

/* Makes the nodes of `count` instances, 1 and up to PLT_INSTANCES_MOST. `order`: scratch, `count`.
 * Returns the root as a child. Cost: each instance once per level. */
uint32_t plt_top_build(plt_top_node *nodes, uint32_t *order, const plt_placed *placed,
                       uint32_t count);

#endif
