/* surface_stats - what an image holds of its corners, and how well
 *
 * SPDX-License-Identifier: MIT */
#ifndef SURFACE_STATS_H
#define SURFACE_STATS_H
#include <stdint.h>

/* What one of the sections holds. */
typedef struct surface_section {
    uint32_t bytes;     /* with padding; 0: there is none */
    uint64_t positions; /* of corners, by which they are found */
    uint64_t split;     /* corners that are found by their triangle */
} surface_section;

typedef struct surface_stats {
    surface_section normals, colours, texcoords;
    surface_section pages;                                /* of all three: bytes */
    uint32_t pages_count, each;                           /* how many, and triangles of each */
    uint32_t colours_kept, colours_distinct, colours_off; /* off: palette.h, furthest */
    double colours_mean;                                  /* ... and mean */
    double texcoords_off; /* the most that one is off by, of the texture's width or height */
} surface_stats;

/* Colours may be off by so much of 255 before there are more than PALETTE_FEW of them. */
enum { SURFACE_COLOURS_NEAR = 2 };

#endif
