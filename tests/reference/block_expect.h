/* block_expect - what a decoded compact image shall hold, from the mesh
 *
 * Source: engine/SPEC.md, sections 4.4, 4.7, 4.9 and 4.11.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_BLOCK_EXPECT_H
#define REFERENCE_BLOCK_EXPECT_H
#include "host_tools/mesh/mesh.h"
#include "tests/reference/block_decoder.h"

/* A triangle of the mesh on the lattice, in canonical order. */
typedef struct expected_triangle {
    int32_t corner[3][3];
    uint32_t number, rotation;
} expected_triangle;

/* The triangles with area on the lattice, in the mesh's order; the caller
 * frees. Each vertex is moved to the lattice number nearest to it before that is
 * rounded to a float. */
expected_triangle *expect_triangles(const mesh *m, const decoded_header *header, uint32_t *count);

/* Puts both in order of their corners, so that they can be compared. */
void expect_sort(expected_triangle *triangle, uint32_t count);

/* The exact boxes of all triangles below each node and leaf. `lo` and `hi`
 * are 0 with float records. Arrays of as many as the image has; the caller
 * frees. */
typedef struct expected_boxes {
    decoded_box *node, *leaf;
} expected_boxes;

expected_boxes expect_boxes(const decoded_image *image);
void expect_boxes_free(expected_boxes *boxes);

/* Whether `outer` holds `inner`: lattice numbers and floats. */
int expect_holds(const decoded_box *outer, const decoded_box *inner);

#endif
