/* blocks - compact blocks built top down, straight from triangles in place
 *
 * Triangles stay where they are (mapped flash, memory, or a source). What is
 * permuted is a list of their indices, 2 bytes each (4 above 65,536 triangles).
 * It lies at the far end of the memory, and the blocks that grow from the front
 * overwrite it. Peak: the finished blocks and the permutation of at most one block.
 *
 * A block fills by "largest subtree first, stop at subtrees that fit a block of
 * their own"; what is left becomes edges. Every block is complete when it is
 * written, except for its links, which are written when the blocks behind them get
 * their addresses, and its check.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BUILDER_BLOCKS_H
#define PLT_BUILDER_BLOCKS_H

#include <stddef.h>
#include <stdint.h>

#include "engine/base/bytes.h"
#include "engine/base/lattice.h"
#include "engine/image/items.h"
#include "engine/image/record_cache.h"
#include "engine/planelet.h"

/* Corners of triangles on the lattice, the scene's quantisation grid: 9 whole numbers
 * each, of plt_corner_width bytes, little-endian. Or, where the geometry stays in float
 * records, their boxes, rounded outwards: low x y z, high x y z. */
typedef struct plt_lattice_triangles {
    const unsigned char *bytes;
    uint32_t count;
    uint32_t width;          /* 2 or 4 */
    uint32_t boxes;          /* 1: boxes of 6 numbers; 0: corners */
    plt_record_cache *cache; /* reads them, if not NULL; then `bytes` are not read */
} plt_lattice_triangles;

/* The numbers of a triangle; valid until the next call. */
static inline const unsigned char *plt_lattice_triangle(const plt_lattice_triangles *t,
                                                        uint32_t triangle) {
    const size_t each = t->boxes ? 6 : 9;
    return t->cache != NULL ? plt_record_cache_find(t->cache, triangle)
                            : t->bytes + each * triangle * t->width;
}

static inline uint32_t plt_lattice_number(const plt_lattice_triangles *t,
                                          const unsigned char *triangle, uint32_t k) {
    const unsigned char *at = triangle + k * t->width;
    return t->width == 2 ? (uint32_t)(at[0] | at[1] << 8) : plt_get_u32(at);
}

typedef struct plt_blocks_job {
    plt_lattice_triangles triangles; /* a single one is written twice */
    uint32_t bits;                   /* of the lattice */
    uint32_t leaf_triangles;         /* K: 1, 2 or 4 */
    uint8_t splits;                  /* enum plt_splits */
    const uint16_t *mesh;            /* index of each triangle's mesh, 0 .. 1022; or NULL */
    unsigned char *memory;           /* aligned to 8 */
    size_t bytes;                    /* of memory */
    void *scratch;                   /* plt_blocks_scratch_bytes, aligned to 8 */
    /* results */
    uint32_t used;                                  /* bytes of blocks so far */
    uint32_t node_bytes;                            /* of them nodes parts */
    uint32_t blocks, nodes, leaves, pairs, written; /* written: triangles */
    uint32_t root;                                  /* link */
    uint32_t depth;                                 /* nodes on the longest path */
    plt_lattice_box box;
    size_t peak; /* most bytes of memory in use at a time */
} plt_blocks_job;

/* Scratch for so many triangles: 29 KB up to 65,536, 34 KB above. */
size_t plt_blocks_scratch_bytes(uint32_t count);

/* Begins; then each step does a split or writes a block. PLT_OK: begun, or
 * done; PLT_MORE; PLT_ERR_ARENA (memory), PLT_ERR_LIMIT (depth, or a block that
 * cannot be made small enough). */
int plt_blocks_begin(plt_blocks_job *job);
int plt_blocks_step(plt_blocks_job *job);

/* The image order of the triangles, for a host that wants it: if not NULL,
 * order[i] becomes the index, in the job, of triangle i of the image. */
void plt_blocks_record_order(plt_blocks_job *job, uint32_t *order);

#endif
