/* material_section - the section of what triangles are made of (SPEC.md, 4.20)
 *
 * SPDX-License-Identifier: MIT */
#ifndef MATERIAL_SECTION_H
#define MATERIAL_SECTION_H
#include "host_tools/mesh/materials.h"
#include "host_tools/pack/pack.h"

typedef struct material_stats {
    uint32_t materials, bytes; /* bytes: of the section; 0: there is none */
    uint32_t bits, runs;       /* bits: of an index; 0: there are runs */
} material_stats;

#define MATERIAL_UNUSED 0xFFFFu

/* Adds those that some triangle has; `m` is by primitive id. Sets, if it is not NULL, number[i] of
 * material i of `m` to that in the section, or MATERIAL_UNUSED. -1, and the image as it was: more
 * than 256 materials, memory is out, or it gets too large. */
int material_section_add(packed *image, const mesh_materials *m, uint16_t *number, const char *name,
                         material_stats *stats, fail *f);

#endif
