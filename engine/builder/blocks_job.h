/* blocks_job - what is to be built as compact blocks, and what came of it
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BUILDER_BLOCKS_JOB_H
#define PLT_BUILDER_BLOCKS_JOB_H

#include "engine/builder/lattice_triangles.h"
#include "engine/planelet_config.h"

/* Why a build ends with PLT_ERR_LIMIT. */
enum plt_blocks_limit {
    PLT_BLOCKS_LIMIT_NONE,
    PLT_BLOCKS_LIMIT_DEPTH, /* more than PLT_DEPTH_MAX levels of nodes */
    PLT_BLOCKS_LIMIT_BLOCK, /* the geometry of one node is more than a block may hold */
    PLT_BLOCKS_LIMIT_BYTES  /* more than PLT_BLOCKS_BYTES_MAX of blocks */
};

typedef struct plt_blocks_job {
    plt_lattice_triangles triangles; /* a single one is written twice */
    uint32_t bits;                   /* of the lattice */
    uint32_t leaf_triangles;         /* K: 1, 2 or 4 */
    uint8_t splits;                  /* enum plt_splits */
#if PLT_BLOCKS_LEVELS
    const uint16_t *levels; /* of a tree that is given (split_given.c), or NULL */
    uint32_t geometry_tail; /* bytes left 0 at the end of every geometry part: the host's to fill */
    const uint32_t *names;  /* of triangles that will move, three each: numbers of their vertices,
                             * by which vertices are one; NULL: by their positions */
    uint32_t *numbers;      /* ... and those of all blocks' vertices, in order; room for all names,
                             * and twice those of a single triangle */
    uint32_t numbered;      /* how many there are */
    uint8_t has_turns;      /* ... and each triangle has two bits behind the positions */
#endif
    const uint16_t *mesh;  /* index of each triangle's mesh, 0 .. 1022; or NULL */
    unsigned char *memory; /* aligned to 8 */
    size_t bytes;          /* of memory */
    void *scratch;         /* plt_blocks_scratch_bytes, aligned to 8 */
    /* results */
    uint32_t used;                                  /* bytes of blocks so far */
    uint32_t node_bytes;                            /* of them nodes parts */
    uint32_t blocks, nodes, leaves, pairs, written; /* written: triangles */
    uint32_t root;                                  /* link */
    uint32_t depth;                                 /* nodes on the longest path */
    uint8_t limit;                                  /* enum plt_blocks_limit */
    plt_lattice_box box;
    size_t peak; /* most bytes of memory in use at a time */
} plt_blocks_job;

#endif
