/* near_grid - the nearest of a set of points, within a distance
 *
 * A hashed grid of cells as long as the distance: a point's neighbours lie in 27 cells. Where
 * floats are further apart than the distance, only points with equal coordinates are neighbours,
 * and each coordinate is a cell.
 *
 * SPDX-License-Identifier: MIT */
#ifndef NEAR_GRID_H
#define NEAR_GRID_H
#include <stddef.h>
#include <stdint.h>

#define NEAR_GRID_NONE UINT32_MAX

typedef struct near_grid {
    const float *vertex; /* 3 floats per vertex; not owned */
    double distance;     /* also the length of a cell */
    uint32_t *first;     /* by hash of a cell: a point of it, + 1; owned */
    uint32_t *next;      /* of each point added: another one with that hash, + 1; owned */
    uint32_t *point;     /* vertices, in the order they were added; owned */
    size_t points, slots;
    uint64_t steps; /* distances computed so far: a cell may hold many points */
} near_grid;

/* For up to `most` points. -1 when memory is out. */
int near_grid_begin(near_grid *g, const float *vertex, double distance, size_t most);
void near_grid_add(near_grid *g, uint32_t vertex);

/* The point nearest to `vertex`, within the distance, and how far it is; the first added of
 * several. Never `vertex` itself. NEAR_GRID_NONE: there is none. */
uint32_t near_grid_find(near_grid *g, uint32_t vertex, double *far);
void near_grid_free(near_grid *g);

/* Bytes of a grid for so many points. */
uint64_t near_grid_bytes(uint64_t most);

#endif
