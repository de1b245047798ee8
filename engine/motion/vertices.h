/* vertices - records of triangles whose vertices are shared
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_VERTICES_H
#define PLT_MOTION_VERTICES_H

#include "engine/base/lattice.h"
#include "engine/motion/frame_block.h"
#include "engine/tree/record.h"

typedef struct plt_vertices {
    const plt_frame_vertex *vertex; /* four bytes more can be read behind the last one */
    const unsigned char *topology;  /* SPEC.md, section 4.15 */
    uint32_t index_bits;            /* of a vertex's number there */
    plt_lattice lattice;            /* bits 0: vertices are floats */
} plt_vertices;

/* Puts the corners of triangle `id` into each of `count` records, in canonical order. What lists
 * say of themselves stays. */
void plt_vertices_put(plt_record *records, uint32_t count, const plt_vertices *v);

#endif
