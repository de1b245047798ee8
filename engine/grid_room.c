/* grid_room - see grid_room.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/grid_room.h"

#include "engine/grid/build.h"

#if PLT_WITH_GRID

#define DENSITY 0.5f /* cells per triangle: DESIGN.md, section 6.3 */

void plt_grid_room_fill(plt_engine *e) {
    if (e->scene.format == PLT_FORMAT_GRID) {
        const plt_grid_job job = {.records = e->scene.gridded.records,
                                  .count = e->scene.gridded.count,
                                  .box = &e->scene.box,
                                  .density = DENSITY,
                                  .room = e->grid_room,
                                  .bytes = e->grid_bytes};
        e->scene.gridded.grid = plt_grid_build(&job);
    }
}

void plt_grid_room_set(plt_engine *e, const plt_layout *layout, void *const part[PLT_PARTS_COUNT]) {
    plt_arena *a = &e->arena;
    if (e->scene.format != PLT_FORMAT_GRID) {
        return;
    }
    const size_t least = layout->bytes[PLT_PART_GRID], before = a->used - least;
    const uint64_t usual = plt_grid_usual_bytes(e->scene.gridded.count);
    const size_t room = (a->bytes - before) / PLT_ALIGN * PLT_ALIGN, peak = a->peak;
    e->grid_room = part[PLT_PART_GRID];
    e->grid_bytes = usual < room ? (size_t)usual : room;
    plt_grid_room_fill(e);
    if (!(PLT_WITH_MOTION && e->options.movable)) {
        e->grid_bytes = e->scene.gridded.grid->bytes;
    }
    plt_arena_release(a, before);
    plt_arena_cut(a, e->grid_bytes);
    a->peak = peak > a->used ? peak : a->used;
}

#endif
