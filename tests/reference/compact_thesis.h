/* compact_thesis - thesis nodes of a compact tree's topology
 *
 * The same inner nodes with exact float boxes, the same lists and pairs, the same positions and
 * primitive ids: the only difference left is the rounding of a compact node's planes. One node
 * per treelet.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_COMPACT_THESIS_H
#define REFERENCE_COMPACT_THESIS_H

#include "engine/tree/compact/validate.h"
#include "host_tools/pack/pack.h"

/* Made from the tree of an opened engine, with lattice geometry and not empty; freed by
 * pack_free. */
packed compact_as_thesis(const plt_block_tree *tree, const plt_info *info);

#endif
