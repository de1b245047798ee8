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
    uint32_t *end; /* vertices where they end, each once, ascending: of those at one position the
                    * one that triangles use first; owned */
    size_t ends;
} open_edges;

/* Of the triangles first .. end - 1 of a mesh whose floats are final. -1 when memory is out. */
int open_edges_find(open_edges *o, const mesh *m, size_t first, size_t end);
/* The most bytes it takes beside the mesh, for so many vertices and triangles. */
uint64_t open_edges_bytes(uint64_t vertices, uint64_t triangles);
void open_edges_free(open_edges *o);

#endif
