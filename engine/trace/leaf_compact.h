/* leaf_compact - a packet against the triangles of a compact block's leaf
 *
 * Vertices are read once and turned into floats; a triangle's corners are put in
 * canonical order (record.h), which strips do not keep.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_LEAF_COMPACT_H
#define PLT_TRACE_LEAF_COMPACT_H

#include "engine/lanes/lanes.h"
#include "engine/trace/packet.h"
#include "engine/trace/triangle.h"
#include "engine/tree/compact/block_tree.h"

/* Triangles in a row. */
typedef struct plt_leaf_run {
    uint32_t first, count; /* of the block's */
    float longest;         /* at least the longest side of the leaf's box */
} plt_leaf_run;

/* Lattice numbers to planes or positions in the scene: exact product, one rounding.
 * The fourth lane means nothing. */
static inline f4 plt_lattice_planes(const plt_lattice *l, f4 numbers) {
    return f4_add(f4_load(l->origin), f4_mul(f4_all(l->step), numbers));
}

/* Triangle `index` of the run, as the test gets it; but for `longest`, which is not set. */
void plt_leaf_triangle(const plt_block_tree *tree, const plt_geometry *geometry,
                       const plt_leaf_run *run, uint32_t index, plt_triangle *to);

/* Tests them for `groups`. */
void plt_leaf_groups(const plt_block_tree *tree, const plt_geometry *geometry,
                     const plt_leaf_run *run, plt_packet *packet, plt_mask groups);

#endif
