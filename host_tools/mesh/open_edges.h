/* open_edges - edges that only one triangle has: holes, borders, and seams that do not meet
 *
 * Vertices of equal positions count as one, whatever their numbers; triangles with two equal
 * corners do not count.
 *
 * SPDX-License-Identifier: MIT */
#ifndef OPEN_EDGES_H
#define OPEN_EDGES_H
#include "host_tools/mesh/mesh.h"

typedef struct open_edges {
    uint64_t count;
    uint32_t *vertex; /* two of each, as one of those at that position; owned */
} open_edges;

/* Of the triangles first .. end - 1 of a mesh whose floats are final. -1 when memory is out. */
int open_edges_find(open_edges *o, const mesh *m, size_t first, size_t end);
void open_edges_free(open_edges *o);

#endif
