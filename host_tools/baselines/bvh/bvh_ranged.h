/* bvh_ranged - packets through a hierarchy whose nodes have a box each, as Wald et al. do it
 *
 * A node's box is tested when the packet comes to it, early hit and frustum first
 * (packet/packet_box.h); the child that the packet's direction comes to first along the node's axis
 * goes first. At a leaf every group is asked, so that none is held against its triangles in vain.
 *
 * Source: Wald, Boulos, Shirley, "Ray tracing deformable scenes using dynamic bounding volume
 * hierarchies", 2007, section 4.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BVH_RANGED_H
#define BASELINES_BVH_RANGED_H

#include "host_tools/baselines/base/binary_tree.h"
#include "host_tools/baselines/packet/packet_box.h"

/* The packet has begun. Masks: rays from the first active group to the last, or active ones. */
void bvh_trace_range(const binary_tree *t, packet_state *p, packet_steps steps);
void bvh_trace_bits(const binary_tree *t, packet_state *p, packet_steps steps);

#endif
