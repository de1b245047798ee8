/* pack_options - how an image is to be made of a mesh
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_OPTIONS_H
#define PACK_OPTIONS_H
#include <stdint.h>

#include "engine/base/lattice.h"
#include "host_tools/mesh/mesh.h"
#include "host_tools/pack/quality.h"
#include "host_tools/treelets/treelet_tree.h"

#define PACK_TREELET_AUTO 0u

typedef struct pack_options {
    uint8_t splits;          /* enum plt_splits */
    uint8_t build;           /* enum plt_build */
    uint32_t leaf_triangles; /* K */
    uint32_t treelet_nodes;  /* N; PACK_TREELET_AUTO: what does best (pack_treelets.h) */
    mesh *spend;             /* the mesh itself: its arrays are freed as soon as they are of no
                              * use, so that others fit; NULL: it stays */
    uint8_t checks;          /* of PLT_BUILD_HOST: what is streamed has checks (checks.h) */
    const poses *poses;      /* of pack_mesh_better: the tree is to be good for these, too, and
                              * `spend` is NULL; NULL: for the mesh alone */
    uint8_t fill, slots;     /* enum treelet_fill, enum treelet_slots; 0 if it is not built here */
} pack_options;

/* Vertices of a sequence (sequence.h) that blocks are to have room for (moving.h). */
typedef struct moving_vertices {
    plt_lattice lattice;    /* which those of the mesh lie on */
    const uint32_t *number; /* of each vertex of the mesh that triangles use */
    uint32_t *of_blocks;    /* result: the numbers of all blocks' vertices, in order; owned */
    uint32_t count;         /* result: so many */
} moving_vertices;

typedef struct compact_options {
    uint8_t splits, build;    /* as above, but not PLT_BUILD_NONE */
    uint8_t lattice_bits;     /* 12 .. 21 */
    uint8_t numbers;          /* keep primitive ids in a section */
    uint8_t checks;           /* ... of which blocks have a check each (checks.h) */
    uint8_t floats;           /* float records, bit exact; the lattice is for boxes alone */
    uint32_t leaf_triangles;  /* K: 1, 2 or 4 */
    const size_t *mesh_end;   /* first triangle after each mesh; NULL: one mesh */
    unsigned meshes;          /* from 1,023 on blocks do not say which mesh they are of */
    uint8_t power;            /* the lattice's step is a power of two */
    double tolerance;         /* take more bits, or fewer, to keep this; 0: the bits as given */
    quality_stats *quality;   /* NULL: the tree stays as it is built; of PLT_BUILD_HOST alone */
    uint32_t quality_seconds; /* as of pack_mesh_better */
    mesh *spend;              /* as above */
    moving_vertices *moving; /* NULL: triangles stay where they are. Else the lattice is theirs, and
                              * positions and rotations are yet to be put (moving_put) */
} compact_options;

#endif
