/* bvh4 - the wide form of a tree: four children per node, four triangles per leaf block
 *
 * Collapsed from a scene's own tree when it is opened with memory to spare
 * (trace/collapse.h), never part of an image. A ray meets all four boxes of a node, or all
 * four triangles of a leaf block, in one register per number.
 *
 * Invariants: a child's box encloses its triangles; every triangle is in one block; a
 * leaf's blocks lie in a row.
 *
 * Source: Wald, Benthin, Boulos, "Getting rid of packets", 2008 (collapsing two levels).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_BVH4_H
#define PLT_TREE_BVH4_H

#include <stddef.h>
#include <stdint.h>

/* A link is how many bytes from node 0 on a node or a leaf's first block is; all lie at multiples
 * of 64. Its lowest bits say which: bit 0, that it is a leaf, bits 1 .. 4, how many blocks follow
 * the first. So a link to a node is an offset as it stands. Node 0 is always there, so that
 * PLT_BVH4_NONE has a valid address. */
#define PLT_BVH4_LEAF 1u
#define PLT_BVH4_NONE PLT_BVH4_LEAF
#define PLT_BVH4_MORE_SHIFT 1
#define PLT_BVH4_MORE_MOST 15u
#define PLT_BVH4_KIND 31u

/* Two cache lines. Children that are not there have lo > hi on every axis, and
 * PLT_BVH4_NONE. */
typedef struct plt_bvh4_node {
    float plane[3][2][4]; /* [axis][lo, hi][child] */
    uint32_t link[4];
    uint32_t pad[4];
} plt_bvh4_node;

/* Lanes without a triangle hold the first again, and -infinity as `longest`: no edge
 * function is within that. */
typedef struct plt_bvh4_block {
    float corner[3][3][4]; /* [corner][axis][triangle], in canonical order (record.h) */
    float longest[4];      /* the longest side of each one's box */
    uint32_t word[4];      /* of primitive_id.h */
    uint32_t pad[4];       /* three cache lines, not two and three quarters anywhere */
} plt_bvh4_block;

enum { PLT_BVH4_ALIGN = 64 };

_Static_assert(sizeof(plt_bvh4_node) == 128 && sizeof(plt_bvh4_block) == 192, "whole cache lines");

typedef struct plt_bvh4 {
    const plt_bvh4_node *nodes;   /* at a multiple of PLT_BVH4_ALIGN */
    const plt_bvh4_block *blocks; /* behind them */
    uint32_t nodes_count, blocks_count;
    uint32_t root;
    uint32_t depth; /* most nodes on a path */
} plt_bvh4;

/* Where a link leads, its lowest bits kept. */
static inline uintptr_t plt_bvh4_at(const plt_bvh4_node *nodes, uint32_t link) {
    return (uintptr_t)nodes + link;
}

static inline const plt_bvh4_node *plt_bvh4_node_at(uintptr_t at) {
    return (const plt_bvh4_node *)at;
}

static inline const plt_bvh4_block *plt_bvh4_block_at(uintptr_t at) {
    return (const plt_bvh4_block *)(at & ~(uintptr_t)PLT_BVH4_KIND);
}

#endif
