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
#include "host_tools/pack/pack_options.h"
#include "host_tools/pack/pack_treelets.h"
#include "host_tools/pack/snapped.h"

/* A whole image in memory; aligned to PLT_ALIGN, freed by pack_free. */
typedef struct packed {
    unsigned char *bytes;
    uint32_t size;
    plt_info info;
    pack_treelets_stats treelets; /* of those that are formed here */
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

/* The same as compact blocks on a lattice; says what the lattice cost. */
int pack_compact(packed *image, const mesh *m, const compact_options *options, const char *name,
                 lattice_loss *loss, fail *f);

#endif
