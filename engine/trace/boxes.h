/* boxes - groups of rays against boxes, by slabs
 *
 * A group meets a box when any of its lanes does, within tmin .. tmax. The distance
 * to a plane is (plane - origin) * (1 / dir), with the origin moved by a bound on the
 * rounding error (packet_set.c), away from near planes and towards far ones. Distances are
 * monotone in the planes: a ray that meets a box meets every box around it.
 *
 * Source: Kay and Kajiya 1986; Karrenberg 2007, section 3.5.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_BOXES_H
#define PLT_TRACE_BOXES_H

#include "engine/base/box.h"
#include "engine/trace/mask.h"
#include "engine/trace/slabs.h"

/* Groups of `groups` that meet a box. */
plt_mask plt_box_groups(const plt_slab_array *slabs, const plt_box *box, plt_mask groups);

/* The same for both children of a node at once. Returns how many groups were tested. */
uint32_t plt_box_pair(const plt_slab_array *slabs, const plt_box child[2], plt_mask groups,
                      plt_mask hit[2]);

/* Where the lowest group of `groups` enters the box, to sort by and for nothing else, as lanes may
 * flush (DESIGN.md, section 8.2); other groups are not looked at. PLT_NOT_ENTERED: it does not. */
#define PLT_NOT_ENTERED PLT_BOX_FAR
float plt_box_entry(const plt_slab_array *slabs, const plt_box *box, plt_mask groups);

#endif
