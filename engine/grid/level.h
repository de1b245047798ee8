/* level - how many cells a box has, and where its triangles go
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_GRID_LEVEL_H
#define PLT_GRID_LEVEL_H

#include "engine/base/box.h"
#include "engine/grid/grid.h"
#include "engine/tree/record.h"

/* Records, or those of a list. */
typedef struct plt_grid_items {
    const plt_record *records;
    const uint32_t *list; /* [count] of indices; NULL: records 0 .. count - 1 */
    uint32_t count;
} plt_grid_items;

/* Lays cells over `box`, at most `wanted` of them (at least one), as close to cubes as their
 * number allows. Sets all but start and reference. */
void plt_grid_level_set(plt_grid_level *level, const plt_box *box, float wanted);

/* Counts into start[cell] how many items reach into each cell: of all, or of one in so `every`
 * many. Returns the sum, or more than `most`: then it has stopped there. */
uint64_t plt_grid_level_count(const plt_grid_level *level, const plt_grid_items *items,
                              uint64_t most, uint32_t every);

/* Once they are counted: sets start and reference, which has room for all. */
void plt_grid_level_fill(const plt_grid_level *level, const plt_grid_items *items);

#endif
