/* build - a grid over records, in the room there is
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_GRID_BUILD_H
#define PLT_GRID_BUILD_H

#include "engine/base/box.h"
#include "engine/grid/grid.h"
#include "engine/tree/record.h"

typedef struct plt_grid_job {
    const plt_record *records;
    uint32_t count;
    const plt_box *box; /* of all records */
    float density;      /* cells per triangle that are wanted */
    uint8_t is_plain;   /* 1: crowded cells stay as they are; for figures (tests/measure) */
    void *room;         /* aligned to PLT_ALIGN */
    size_t bytes;       /* of it, plt_grid_least_bytes(count) at least */
} plt_grid_job;

/* Room for a grid of one cell; and room that hardly any scene wants more than. Multiples of
 * PLT_ALIGN. */
uint64_t plt_grid_least_bytes(uint32_t triangles);
uint64_t plt_grid_usual_bytes(uint32_t triangles);

/* Makes a grid at the front of the room. If its references do not fit, it has half as many cells,
 * and so on. Cost: two passes over the records, and one over the cells; each try one pass more. */
const plt_grid *plt_grid_build(const plt_grid_job *job);

#endif
