/* reinsert - moves a subtree to where it makes the tree's boxes smallest
 *
 * Sources: Bittner, Hapala and Havran, "Fast Insertion-Based Optimization of Bounding Volume
 * Hierarchies", 2013; Meister and Bittner, "Parallel Reinsertion for Bounding Volume Hierarchy
 * Optimization", 2018 (the search, from the node upwards).
 *
 * SPDX-License-Identifier: MIT */
#ifndef REINSERT_H
#define REINSERT_H
#include "host_tools/pack/list_tree.h"

/* Takes `node` out of the tree and puts it back where, beside any node that was not above it, the
 * sum of all inner nodes' areas is least, if that is less than before and its new path is no
 * longer than PLT_DEPTH_MAX inner nodes. Returns whether it moved. The tree's height may be one
 * more, as an intermediate node's is. */
int reinsert(list_tree *t, uint32_t node);

#endif
