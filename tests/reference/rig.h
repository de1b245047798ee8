/* rig - a mesh, packed and opened in an arena of exactly its need
 *
 * The arena is a heap block, so sanitizers see an access beyond it.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_RIG_H
#define REFERENCE_RIG_H

#include <stddef.h>

#include "engine/planelet.h"
#include "host_tools/mesh/mesh.h"
#include "host_tools/pack/pack.h"

typedef struct rig_config {
    pack_options pack;
    plt_options run;
} rig_config;

typedef struct rig {
    packed image;
    void *arena;
    size_t arena_bytes;
    plt_engine *engine;
    plt_fault fault;
} rig;

/* K, N, build and splits of a configuration; the largest packet of this build. */
rig_config rig_config_of(uint32_t leaf_triangles, uint32_t treelet_nodes, uint8_t build,
                         uint8_t splits);

/* The status of plt_open, or PLT_ERR_LIMIT when the packer refused. */
int rig_open(rig *r, const mesh *m, const rig_config *config);

/* ... in an arena of so many bytes more than it needs, rounded to PLT_ALIGN. */
int rig_open_spare(rig *r, const mesh *m, const rig_config *config, size_t spare);
void rig_close(rig *r);

/* The image as a mapped source. */
plt_source rig_source(const packed *image);

/* Most triangles, up to `wanted`, that this build's depth can hold. */
uint32_t rig_triangles(uint32_t wanted, uint32_t leaf_triangles);

/* Whether this build's limits are below the usual ones: then a scene may be
 * refused with PLT_ERR_LIMIT. */
int rig_is_tiny(void);

/* The name of a configuration, for messages; overwritten by the next call. */
const char *rig_name(const rig_config *config);

#endif
