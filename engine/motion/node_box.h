/* node_box - boxes of lists and nodes in lanes, and how a refit writes them
 *
 * A box is two registers, x y z and a lane that means nothing.
 *
 * Source: Karrenberg 2007, figure 3.6; Lauterbach, Yoon, Tuft, Manocha, "RT-DEFORM: Interactive
 * Ray Tracing of Dynamic Scenes using BVHs", 2006, section 4 (the ratio of areas).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_NODE_BOX_H
#define PLT_MOTION_NODE_BOX_H

#include "engine/motion/node_box_types.h"
#include "engine/planelet_config.h"
#include "engine/tree/words.h"

#if PLT_LANES_REGISTERS
#include "engine/motion/node_box_code.h"
#else

plt_box4 plt_record_box4(const plt_record *r);

/* Of one list, or of two beside each other. */
plt_box4 plt_lists_box4(const plt_record *records, uint32_t link);

/* Three planes of a node, of which `old` are there; the owner bits of those that are not the
 * parent's. */
uint32_t plt_planes_put(uint32_t *word, f4 old, f4 parent, f4 left, f4 right);

/* Both children's boxes into the node; its own. */
plt_box4 plt_node_fit(plt_node *node, plt_box4 left, plt_box4 right);

float plt_box4_half_area(plt_box4 b);

/* Of a node that comes, or goes (`sign` 1 or -1). */
void plt_areas_add(plt_areas *to, int sign, plt_box4 parent, plt_box4 left, plt_box4 right);

#endif

/* If anybody wants to know. */
static inline void plt_areas_count(plt_areas *to, int sign, plt_box4 parent, plt_box4 left,
                                   plt_box4 right) {
    if (PLT_WITH_REBUILD && to->is_wanted) {
        plt_areas_add(to, sign, parent, left, right);
    }
}

#endif
