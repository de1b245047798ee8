/* crowded - grids of their own for cells with too many references
 *
 * What a uniform grid is bad at is a teapot in a stadium: one cell has all that is looked at.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_GRID_CROWDED_H
#define PLT_GRID_CROWDED_H

#include "engine/grid/grid.h"
#include "engine/tree/record.h"

/* Gives cells of `g`, over `count` records, that are crowded a level, if they are few, as far as
 * the room of `bytes` goes, whose front is `g`. */
void plt_grid_refine(plt_grid *g, const plt_record *records, uint32_t count, size_t bytes);

#endif
