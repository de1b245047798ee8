/* pack_need - the memory that building an image takes, from the counts alone
 *
 * Upper bounds of heap_peak (base/heap.h), for the worst tree of so many triangles. They count
 * what is asked for; room for nodes and blocks that do not come about is never touched.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_NEED_H
#define PACK_NEED_H
#include <stdint.h>

#include "host_tools/pack/pack_options.h"

typedef struct pack_counts {
    uint64_t vertices, triangles;
    uint64_t held; /* bytes in use before, the mesh's among them */
    uint64_t mesh; /* the mesh's, which go where options->spend says so */
} pack_counts;

/* Of pack_mesh, or with `is_high` of pack_mesh_better. */
uint64_t pack_need_thesis(const pack_options *options, int is_high, const pack_counts *counts);
/* Of pack_compact. */
uint64_t pack_need_compact(const compact_options *options, const pack_counts *counts);

#endif
