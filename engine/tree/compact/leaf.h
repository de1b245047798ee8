/* leaf - the triangles behind a slot of a compact block
 *
 * The geometry part of a block numbers its vertices by first use; triangles are
 * strips. A start bit says that a triangle begins a strip, a swap bit over which edge
 * the strip goes on. Any leaf is reached by counting ones. SPEC.md, section 4.10, has every bit.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_COMPACT_LEAF_H
#define PLT_TREE_COMPACT_LEAF_H

#include "engine/tree/compact/block.h"

#define PLT_GEOMETRY_HEADER_BYTES 8
#define PLT_LEAF_TRIANGLES_MOST 8 /* 2 K */
#define PLT_LEAF_VERTICES_MOST (3 * PLT_LEAF_TRIANGLES_MOST)

#define PLT_BLOCK_TRIANGLES_MOST ((PLT_BLOCK_NODES_MOST + 1) * PLT_LEAF_TRIANGLES_MOST)

/* Strings of counts, a bit per leaf each, for lists of at most `k` triangles: none for
 * K = 1, of count - 1 one for K = 2 and two for K = 4. */
static inline uint32_t plt_geometry_count_strings(uint32_t k) {
    return k == 4 ? 2 : k == 2;
}

/* Bits of a reference to one of so many vertices. */
static inline uint32_t plt_geometry_ref_bits(uint32_t vertices) {
    return vertices > 1 ? plt_bits_for(vertices - 1) : 0;
}

/* Bit positions of the strings in a geometry part, all from its start, and running
 * ranks in the two that are counted in. */
typedef struct plt_geometry {
    const unsigned char *bytes;
    uint32_t k; /* K: most triangles per list */
    uint32_t leaves;
    uint32_t first_triangle;             /* index, in image order */
    uint32_t mesh;                       /* index + 1 of the mesh of all triangles; 0: several */
    uint32_t vertices, triangles, slots; /* slots: references, 1 or 3 per triangle */
    uint32_t news_ones;                  /* slots of a new vertex; `vertices` if valid */
    uint32_t counts, starts, swaps, news, refs, positions;
    uint32_t ref_bits, axis_bits[3], axis_mask[4], vertex_bits;
    uint32_t base[4]; /* the bounds' low corner */
    uint16_t starts_before[PLT_RANKS(PLT_BLOCK_TRIANGLES_MOST)];
    uint16_t news_before[PLT_RANKS(3 * PLT_BLOCK_TRIANGLES_MOST)];
} plt_geometry;

/* Triangles first .. first + count - 1 (count <= 8), and what was counted before them. */
typedef struct plt_leaf_place {
    uint32_t first, count;
    uint32_t slot; /* references before them */
    uint32_t news; /* new vertices among those */
} plt_leaf_place;

/* A leaf among those of its block, and the pairs before it. */
typedef struct plt_leaf_rank {
    uint32_t leaf, pairs;
    int pair; /* it is one */
} plt_leaf_rank;

/* Opens the geometry part of a block that has one. */
void plt_geometry_open(plt_geometry *g, const plt_block *block, const plt_lattice_box *bounds,
                       uint32_t k);

/* For one leaf alone, whose place it finds: there are no ranks for others. */
void plt_geometry_open_leaf(plt_geometry *g, const plt_block *block, const plt_lattice_box *bounds,
                            uint32_t k, const plt_leaf_rank *rank, plt_leaf_place *at);

/* Only header and counts: all there is when the triangles are float records. */
void plt_geometry_open_counts(plt_geometry *g, const plt_block *block, uint32_t k);

/* The first triangle of leaf `leaf`, `pairs` of the leaves before it being pairs, and
 * how many it has; `pair`: it is one. */
uint32_t plt_leaf_find(const plt_geometry *g, uint32_t leaf, uint32_t pairs, int pair,
                       uint32_t *count);

/* Lattice position of a vertex of the part. */
void plt_leaf_vertex(const plt_geometry *g, uint32_t vertex, uint32_t position[3]);

/* A vertex, in lattice coordinates; the traversal makes them the scene's floats in the same
 * memory, to keep its stack small. The fourth means nothing. */
typedef union plt_vertex {
    uint32_t number[4];
    float scene[4];
} plt_vertex;

/* Triangles in a row: the vertices that their strips run over, and the indices of each
 * one's three among them, 8 bits each. */
typedef struct plt_leaf {
    uint32_t vertices;
    plt_vertex vertex[PLT_LEAF_VERTICES_MOST];
    uint32_t corner[PLT_LEAF_TRIANGLES_MOST];
} plt_leaf;

static inline uint32_t plt_leaf_corner(const plt_leaf *leaf, uint32_t triangle, unsigned corner) {
    return leaf->corner[triangle] >> 8 * corner & 0xFFu;
}

void plt_leaf_read_at(const plt_geometry *g, const plt_leaf_place *at, plt_leaf *leaf);

/* Triangles first .. first + count - 1 (count <= 8), their corners as strips give them. */
void plt_leaf_read(const plt_geometry *g, uint32_t first, uint32_t count, plt_leaf *leaf);

#endif
