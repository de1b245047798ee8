/* surface - adds normals, colours and texture coordinates to a finished image (SPEC.md, 4.18, 4.19,
 * 4.21)
 *
 * SPDX-License-Identifier: MIT */
#ifndef SURFACE_H
#define SURFACE_H
#include "host_tools/mesh/corners.h"
#include "host_tools/pack/pack.h"

/* What one of the sections holds. */
typedef struct surface_section {
    uint32_t bytes;     /* with padding; 0: there is none */
    uint64_t positions; /* of corners, by which they are found */
    uint64_t split;     /* corners that are found by their triangle */
} surface_section;

typedef struct surface_stats {
    surface_section normals, colours, texcoords;
    uint32_t colours_kept, colours_distinct, colours_off; /* off: palette.h, furthest */
    double colours_mean;                                  /* ... and mean */
    double texcoords_off; /* the most that one is off by, of the texture's width or height */
} surface_stats;

/* Colours may be off by so much of 255 before there are more than PALETTE_FEW of them. */
enum { SURFACE_COLOURS_NEAR = 2 };

/* Of an image without a sequence or instances, if compact with build host and primitive ids. `c` is
 * by primitive id; what it does not have the image does not get. -1, and the image with less than
 * all of it: memory is out, or it gets too large. */
int surface_add(packed *image, const mesh_corners *c, const char *name, surface_stats *stats,
                fail *f);

#endif
