/* blocks_state - what the builder of compact blocks keeps in its scratch
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BUILDER_BLOCKS_STATE_H
#define PLT_BUILDER_BLOCKS_STATE_H

#include <string.h>

#include "engine/builder/blocks_job.h"
#include "engine/builder/split.h"
#include "engine/tree/compact/leaf.h"

#define PLT_BLOCK_VERTICES_MOST 640
#define PLT_BLOCK_HASH 1024

/* A range of the permutation. `decoded` is the box that a traversal will have for it, from
 * planes in whole steps, which are rounded outwards; planes of its children count from
 * there. `exact` is the smallest box around its triangles, which splits and bounds of
 * blocks go by. */
typedef struct plt_block_range {
    uint32_t first, count;
    plt_lattice_box decoded, exact;
    uint16_t depth;
    uint8_t parent, child; /* node of this block that leads here */
} plt_block_range;

/* An edge that waits for its block. */
typedef struct plt_block_edge_waiting {
    uint32_t first, count;
    plt_lattice_box bounds;
    uint32_t link_at; /* byte of memory where its link goes; PLT_LINK_NONE: the root's */
    uint32_t depth;
} plt_block_edge_waiting;

typedef struct plt_block_node {
    uint8_t plane[6];
    uint8_t owners;  /* six bits, xmin first */
    uint8_t kind[2]; /* enum plt_slot_kind */
    uint8_t node[2]; /* inner children */
    uint8_t level;   /* nodes above it in this block */
    uint32_t first[2], count[2];
} plt_block_node;

/* A triangle of a strip: which of the leaf, rotated by how many corners; whether it
 * starts a strip, and its swap bit. */
typedef struct plt_strip_step {
    uint8_t triangle, rotation, start, swap;
} plt_strip_step;

typedef struct plt_blocks_state {
    plt_blocks_job *job;
    uint32_t *order; /* of plt_blocks_record_order */
    unsigned char *permutation;
    uint32_t index_bytes; /* 2 or 4 */
    /* edges that wait, the lowest range on top */
    plt_block_edge_waiting *edge; /* behind this struct */
    uint32_t waiting, edges_most;
    uint32_t checked; /* bytes of blocks whose checks are written, at the end */
    /* the block in hand */
    plt_block_edge_waiting at;
    plt_block_range pending[PLT_BLOCK_NODES_MOST + 1];
    plt_block_node node[PLT_BLOCK_NODES_MOST];
    uint8_t order_of[PLT_BLOCK_NODES_MOST]; /* nodes, breadth first */
    uint32_t pendings, nodes, nodes_most;
    uint8_t open;
    /* its geometry */
    uint64_t vertex[PLT_BLOCK_VERTICES_MOST];
    uint16_t hash[PLT_BLOCK_HASH];
    uint16_t reference[3 * PLT_BLOCK_TRIANGLES_MOST];
    uint8_t flags[PLT_BLOCK_TRIANGLES_MOST]; /* 1: start, 2: swap */
#if PLT_BLOCKS_LEVELS
    uint8_t rotation[PLT_BLOCK_TRIANGLES_MOST]; /* of each in its strip's order */
#endif
    uint8_t leaf_count[PLT_BLOCK_NODES_MOST + 1]; /* triangles per leaf */
    uint32_t leaves, triangles, references, vertices;
    uint32_t mesh;       /* index + 1 of the mesh of all its triangles; 0: several, or not known */
    plt_split_bins bins; /* splitting */
} plt_blocks_state;

static inline uint32_t plt_permuted(const plt_blocks_state *s, uint32_t i) {
    uint16_t small;
    uint32_t large;
    if (s->index_bytes == 2) {
        memcpy(&small, s->permutation + 2 * (size_t)i, 2);
        return small;
    }
    memcpy(&large, s->permutation + 4 * (size_t)i, 4);
    return large;
}

static inline void plt_permute(plt_blocks_state *s, uint32_t i, uint32_t triangle) {
    const uint16_t small = (uint16_t)triangle;
    if (s->index_bytes == 2) {
        memcpy(s->permutation + 2 * (size_t)i, &small, 2);
    } else {
        memcpy(s->permutation + 4 * (size_t)i, &triangle, 4);
    }
}

/* Bits of a coordinate of a vertex: of its offset in the block's bounds; or, where vertices have
 * names, of any on the lattice. */
static inline uint32_t plt_blocks_axis_bits(const plt_blocks_state *s, int axis) {
#if PLT_BLOCKS_LEVELS
    if (s->job->names != NULL) {
        return s->job->bits;
    }
#endif
    return plt_bits_for(s->at.bounds.hi[axis] - s->at.bounds.lo[axis]);
}

#if PLT_BLOCKS_LEVELS
/* A vertex's number instead of its position, 21 bits and the rest; and back from its key. */
static inline void plt_block_name_put(uint32_t corner[3], uint32_t name) {
    corner[0] = name >> 21;
    corner[1] = name & 0x1FFFFFu;
    corner[2] = 0;
}

static inline uint32_t plt_block_name_of(uint64_t key) {
    return (uint32_t)(key >> 21);
}
#endif

/* PLT_ERR_LIMIT, and why. */
static inline int plt_blocks_limited(plt_blocks_state *s, enum plt_blocks_limit limit) {
    s->job->limit = (uint8_t)limit;
    return PLT_ERR_LIMIT;
}

/* plt_split_records, for a range of the permutation. (split_lattice.c) */
uint32_t plt_split_lattice(plt_blocks_state *items, const plt_split_range *range,
                           const plt_lattice_box *box, plt_lattice_box child[2]);

#if PLT_BLOCKS_LEVELS
/* The same by job->levels, of two items and more. (split_given.c) */
uint32_t plt_split_given(const plt_blocks_state *s, uint32_t begin, uint32_t end,
                         plt_lattice_box child[2]);
#endif

/* The order and rotations of a leaf's triangles that take few strips, with start and
 * swap bits. `count` is 1 .. 8. (strips.c) */
void plt_strips_find(const uint32_t corner[][3][3], uint32_t count, plt_strip_step *step);

/* Collects the geometry of the block in hand; 0 when it exceeds what a block may
 * hold. Then writes the block. (blocks_geometry.c, blocks_write.c) */
int plt_blocks_collect_geometry(plt_blocks_state *s);
uint32_t plt_blocks_geometry_bytes(const plt_blocks_state *s); /* behind the header */
int plt_blocks_write(plt_blocks_state *s);

/* Where in the block the link of each edge lies: offset[2 * node + child]. */
void plt_blocks_link_offsets(const plt_blocks_state *s, uint32_t *offset);

#endif
