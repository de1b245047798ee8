/* triangle_set - the triangles of a baseline, as records of the engine
 *
 * Corners stand in the engine's order (tree/canonical.h), since its arithmetic depends on it.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_TRIANGLE_SET_H
#define BASELINES_TRIANGLE_SET_H

#include "engine/tree/record.h"
#include "host_tools/mesh/mesh.h"

typedef struct triangle_set {
    plt_record *record; /* of id i at i */
    uint32_t count;
    plt_box box; /* empty when there are none */
} triangle_set;

/* From nothing, all zero, or again of as many triangles. -1: no memory. */
int triangle_set_fill(triangle_set *t, const mesh *m);
void triangle_set_free(triangle_set *t);

/* Records of a mesh that has moved: each has its id's new corners, where it stands, and the same
 * last bit. */
void triangle_set_move(plt_record *records, uint32_t count, const mesh *m);

#endif
