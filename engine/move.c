/* move - the public call by which triangles move
 *
 * SPDX-License-Identifier: MIT */
#include "engine/move.h"
#include "engine/base/fault.h"
#include "engine/motion/corners.h"
#include "engine/motion/refit.h"

/* Records of a movable scene lie in the arena. */
plt_record *plt_records_of(plt_engine *e) {
    const plt_record *r =
        e->scene.format == PLT_FORMAT_LIST ? e->scene.list.records : e->scene.thesis.records;
    return (plt_record *)(uintptr_t)r;
}

void plt_refit_all(plt_engine *e) {
    const plt_tree *tree = &e->scene.thesis;
    if (e->scene.format == PLT_FORMAT_LIST || tree->root == PLT_LINK_NONE) {
        e->scene.box = plt_records_box(plt_records_of(e), 0, e->scene.info.triangles);
        return;
    }
    plt_refit_job job = {.nodes = (plt_node *)(uintptr_t)tree->nodes,
                         .records = tree->records,
                         .root = tree->root,
                         .levels = e->refit_levels};
    plt_refit(&job);
    e->scene.box = job.box;
}

void plt_moved(plt_engine *e) {
    if (e->scene.info.triangles > 0) {
        memcpy(e->scene.info.lo, e->scene.box.lo, sizeof e->scene.info.lo);
        memcpy(e->scene.info.hi, e->scene.box.hi, sizeof e->scene.info.hi);
    }
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
    plt_corners_put(plt_records_of(e), count, corners);
    plt_refit_all(e);
    plt_moved(e);
    return PLT_OK;
}
