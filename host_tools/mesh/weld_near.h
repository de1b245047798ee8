/* weld_near - vertices that almost meet become one
 *
 * For seams that a program has written in two precisions. A vertex goes to the nearest of
 * those that stay, which are further apart than the distance that is welded; so none moves
 * by more than that distance, whatever chains there are.
 *
 * SPDX-License-Identifier: MIT */
#ifndef WELD_NEAR_H
#define WELD_NEAR_H
#include "host_tools/mesh/mesh.h"
#include "host_tools/mesh/open_edges.h"

typedef struct weld_near_result {
    uint64_t moved;     /* positions that went to another; equal positions count once */
    uint64_t collapsed; /* triangles two of whose corners have become one */
} weld_near_result;

/* Welds the vertices that triangles first .. end - 1 use, within `distance` > 0, by changing
 * the triangles' corners; the vertices stay. Takes time and memory for these triangles and the
 * vertices from the first to the last that they use. -1 when memory is out. */
int weld_near(mesh *m, size_t first, size_t end, double distance, weld_near_result *result);

/* A distance, rounded up to one digit, that closes open edges whose ends all but meet
 * (within 1e-4 of the longest side) and takes no triangle's area, and how many stay open with
 * it. `distance` is 0 when there is none. -1 when memory is out. */
int weld_near_suggest(const mesh *m, size_t first, size_t end, const open_edges *o,
                      double *distance, uint64_t *left);

/* The most bytes that each takes beside the mesh, for a file of so many vertices and triangles;
 * the ends of the open edges are among those of weld_near_suggest. */
uint64_t weld_near_bytes(uint64_t vertices);
uint64_t weld_near_suggest_bytes(uint64_t vertices, uint64_t triangles);

#endif
