/* leaf_compact - a packet against the triangles of a compact block's leaf
 *
 * Vertices are read once and turned into floats; a triangle's corners are put in
 * canonical order (record.h), which strips do not keep.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_LEAF_COMPACT_H
#define PLT_TRACE_LEAF_COMPACT_H

#include "engine/base/small_stack.h"
#include "engine/lanes/lanes.h"
#include "engine/trace/packet.h"
#include "engine/trace/triangle.h"
#include "engine/tree/canonical.h"
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

/* Floats of the lattice numbers of all vertices, and the keys that order them. */
static inline void plt_leaf_positions(plt_leaf *leaf, const plt_lattice *l, uint64_t key[]) {
    for (uint32_t i = 0; i < leaf->vertices; i++) {
        plt_vertex *v = &leaf->vertex[i];
        key[i] = plt_lattice_key(v->number);
        f4_store(v->scene, plt_lattice_planes(l, f4_of_u4(u4_load(v->number))));
    }
}

/* The three indices of `corner`, a byte each, in canonical order. */
static inline uint32_t plt_leaf_ordered(uint32_t corner, const uint64_t key[]) {
    const uint64_t a = key[corner & 0xFFu], b = key[corner >> 8 & 0xFFu], c = key[corner >> 16];
    const uint32_t first = plt_canonical_first(b < a, c < a, c < b);
    return (uint32_t)(((uint64_t)corner << 24 | corner) >> 8 * first) & 0xFFFFFFu;
}

/* Puts the corners of `count` triangles in canonical order, and places all vertices. Keys are
 * needed no longer than that: apart, they are not on the stack below the tests of triangles. */
PLT_APART_ON_SMALL_STACKS static void plt_leaf_place_corners(plt_leaf *leaf, uint32_t count,
                                                             const plt_lattice *l) {
    uint64_t key[PLT_LEAF_VERTICES_MOST];
    plt_leaf_positions(leaf, l, key);
    for (uint32_t i = 0; i < count; i++) {
        leaf->corner[i] = plt_leaf_ordered(leaf->corner[i], key);
    }
}

/* Triangle `index` of the run, as the test gets it; but for `longest`, which is not set. */
void plt_leaf_triangle(const plt_block_tree *tree, const plt_geometry *geometry,
                       const plt_leaf_run *run, uint32_t index, plt_triangle *to);

/* Tests them for `groups`. */
void plt_leaf_groups(const plt_block_tree *tree, const plt_geometry *geometry,
                     const plt_leaf_run *run, plt_packet *packet, plt_mask groups);

#endif
