/* grid_room - the part of the arena that a grid is made in
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_GRID_ROOM_H
#define PLT_GRID_ROOM_H

#include "engine/engine.h"

#if PLT_WITH_GRID
/* Makes the grid, where the scene is to have one, once all that runs was cut, as `layout` says. The
 * grid's part, the last, takes more if there is room, and if triangles do not move gives back what
 * is left. */
void plt_grid_room_set(plt_engine *e, const plt_layout *layout, void *const part[PLT_PARTS_COUNT]);

/* Makes it anew there, of records that have moved. */
void plt_grid_room_fill(plt_engine *e);
#else
static inline void plt_grid_room_set(plt_engine *e, const plt_layout *layout,
                                     void *const part[PLT_PARTS_COUNT]) {
    (void)e;
    (void)layout;
    (void)part;
}

static inline void plt_grid_room_fill(plt_engine *e) {
    (void)e;
}
#endif

#endif
