/* unit - the triangles behind a slot of a compact block
 *
 * The geometry part of a block numbers its vertices by first use; triangles are
 * strips with a bit for "a new strip" and one for "which edge goes on". Any
 * unit is reached by counting ones. SPEC.md, section 4.10, has every bit.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_UNIT_H
#define PLT_TREE_UNIT_H

#include "engine/tree/block.h"

#define PLT_GEOMETRY_HEADER_BYTES 8
#define PLT_UNIT_TRIANGLES_MOST 8 /* 2 K */

/* Bit positions of the strings in a geometry part, all from its start. */
typedef struct plt_geometry {
    const unsigned char *bytes;
    uint32_t k;                          /* most triangles a list */
    uint32_t first_triangle;             /* number, in image order */
    uint32_t mesh;                       /* number + 1 of the mesh of all triangles; 0: several */
    uint32_t vertices, triangles, slots; /* slots: references, 1 or 3 a triangle */
    uint32_t counts, starts, turns, news, refs, positions;
    uint32_t ref_bits, axis_bits[3], vertex_bits;
    uint32_t base[3]; /* the frame's low corner */
} plt_geometry;

/* Opens the geometry part of a block that has one. */
void plt_geometry_open(plt_geometry *g, const plt_block *block, const plt_lattice_box *frame,
                       uint32_t k);

/* Only header and counts: all there is when the triangles are float records. */
void plt_geometry_open_counts(plt_geometry *g, const plt_block *block, uint32_t k);

/* Where unit `unit` begins, `pairs` of the units before it being pairs; and how
 * many triangles it has. */
uint32_t plt_unit_first(const plt_geometry *g, uint32_t unit, uint32_t pairs);
uint32_t plt_unit_count(const plt_geometry *g, uint32_t unit, int pair);

/* Lattice position of a vertex of the part. */
void plt_unit_vertex(const plt_geometry *g, uint32_t vertex, uint32_t position[3]);

/* Lattice corners of triangles first .. first + count - 1 (count <= 8), as
 * strips give them. */
void plt_unit_corners(const plt_geometry *g, uint32_t first, uint32_t count,
                      uint32_t corner[][3][3]);

#endif
