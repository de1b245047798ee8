/* quality_order - the order and the tree that compact blocks are to have
 *
 * SPDX-License-Identifier: MIT */
#ifndef QUALITY_ORDER_H
#define QUALITY_ORDER_H
#include "host_tools/pack/quality.h"
#include "host_tools/pack/snapped.h"

/* Builds a thesis tree of the triangles' boxes by `splits` (enum plt_splits), in lists of at most
 * `leaf_triangles`, improves it (quality.h) and puts the triangles into its order. `levels` gets a
 * number per triangle, the depth of the node that parts it from the one before it
 * (engine/builder/split_given.c); the triangles of a list are parted below all nodes. PLT_OK;
 * PLT_ERR_ARENA: out of memory; PLT_ERR_LIMIT: PLT_DEPTH_MAX levels are too few, and all is as
 * it was. */
int quality_order(snapped *s, uint8_t splits, uint32_t leaf_triangles, int are_boxes,
                  uint32_t seconds, quality_stats *stats, uint16_t *levels);

#endif
