/* move - the public call by which triangles move
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/fault.h"
#include "engine/engine.h"
#include "engine/grid_room.h"
#include "engine/motion/corners.h"
#include "engine/motion/refit.h"

/* Records of a movable scene lie in the arena. */
static plt_record *records_of(plt_engine *e) {
    const plt_record *r = e->scene.format == PLT_FORMAT_GRID   ? e->scene.gridded.records
                          : e->scene.format == PLT_FORMAT_LIST ? e->scene.list.records
                                                               : e->scene.thesis.records;
    return (plt_record *)(uintptr_t)r;
}

static plt_box refit(plt_engine *e, plt_record *records) {
    const plt_tree *tree = &e->scene.thesis;
    if (e->scene.format == PLT_FORMAT_GRID || e->scene.format == PLT_FORMAT_LIST ||
        tree->root == PLT_LINK_NONE) {
        return plt_records_box(records, 0, e->scene.info.triangles);
    }
    plt_refit_job job = {.nodes = (plt_node *)(uintptr_t)tree->nodes,
                         .records = records,
                         .root = tree->root,
                         .levels = e->refit_levels};
    plt_refit(&job);
    return job.box;
}

int plt_move(plt_engine *e, const float (*corners)[9], plt_fault *fault) {
    const uint32_t count = e->scene.info.triangles;
    plt_fault_set(fault, PLT_OK, 0, "no fault");
    if (!e->options.movable) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0, "the scene was not opened to be moved");
    }
    const uint32_t refused = plt_corners_refused(corners, count);
    if (refused < count) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, refused,
                             "a corner is not a number, or beyond 2^40");
    }
    e->rendering.done = 1;
    plt_record *records = records_of(e);
    plt_corners_put(records, count, corners);
    e->scene.box = refit(e, records);
    if (count > 0) {
        memcpy(e->scene.info.lo, e->scene.box.lo, sizeof e->scene.info.lo);
        memcpy(e->scene.info.hi, e->scene.box.hi, sizeof e->scene.info.hi);
    }
    plt_grid_room_fill(e);
    return PLT_OK;
}
