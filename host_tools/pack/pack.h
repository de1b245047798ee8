/* pack - from a mesh to a scene image
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_H
#define PACK_H
#include <stdint.h>

#include "engine/planelet.h"
#include "engine/tree/record.h"
#include "host_tools/base/fail.h"
#include "host_tools/base/output.h"
#include "host_tools/mesh/mesh.h"
#include "host_tools/pack/quality.h"
#include "host_tools/pack/snapped.h"

typedef struct pack_options {
    uint8_t splits;          /* enum plt_splits */
    uint8_t build;           /* enum plt_build */
    uint32_t leaf_triangles; /* K */
    uint32_t treelet_nodes;  /* N */
    mesh *spend;             /* the mesh itself: its arrays are freed as soon as they are of no
                              * use, so that others fit; NULL: it stays */
} pack_options;

/* A whole image in memory; aligned to PLT_ALIGN, freed by pack_free. */
typedef struct packed {
    unsigned char *bytes;
    uint32_t size;
    plt_info info;
} packed;

/* Triangle i of the mesh gets primitive id i. `name` is for errors. */
int pack_mesh(packed *image, const mesh *m, const pack_options *options, const char *name, fail *f);
/* The same with a tree that is improved for at most so many seconds, 0: as long as it takes
 * (quality.h); built by the host. */
int pack_mesh_better(packed *image, const mesh *m, const pack_options *options, uint32_t seconds,
                     quality_stats *stats, const char *name, fail *f);
void pack_free(packed *image);

/* Triangle `triangle` of the mesh as a float record, with its primitive id and rotation. */
void pack_record(plt_record *record, const mesh *m, size_t triangle);

typedef struct compact_options {
    uint8_t splits, build;    /* as above, but not PLT_BUILD_NONE */
    uint8_t lattice_bits;     /* 12 .. 21 */
    uint8_t numbers;          /* keep primitive ids in a section */
    uint8_t floats;           /* float records, bit exact; the lattice is for boxes alone */
    uint32_t leaf_triangles;  /* K: 1, 2 or 4 */
    const size_t *mesh_end;   /* first triangle after each mesh; NULL: one mesh */
    unsigned meshes;          /* from 1,023 on blocks do not say which mesh they are of */
    uint8_t power;            /* the lattice's step is a power of two */
    double tolerance;         /* take more bits, or fewer, to keep this; 0: the bits as given */
    quality_stats *quality;   /* NULL: the tree stays as it is built; of PLT_BUILD_HOST alone */
    uint32_t quality_seconds; /* as of pack_mesh_better */
    mesh *spend;              /* as above */
} compact_options;

/* The same as compact blocks on a lattice; says what the lattice cost. */
int pack_compact(packed *image, const mesh *m, const compact_options *options, const char *name,
                 lattice_loss *loss, fail *f);

#endif
