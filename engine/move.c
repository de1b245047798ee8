/* move - the public call by which triangles move
 *
 * SPDX-License-Identifier: MIT */
#include "engine/move.h"

#include "engine/base/fault.h"
#include "engine/engine.h"
#include "engine/grid_room.h"
#include "engine/motion/corners.h"

#if PLT_WITH_THESIS
/* Records of a movable scene lie in the arena. */
plt_record *plt_records_of(plt_engine *e) {
    const plt_record *r = e->scene.format == PLT_FORMAT_GRID   ? e->scene.gridded.records
                          : e->scene.format == PLT_FORMAT_LIST ? e->scene.list.records
                                                               : e->scene.thesis.records;
    return (plt_record *)(uintptr_t)r;
}

int plt_has_nodes(const plt_engine *e) {
    return e->scene.format == PLT_FORMAT_THESIS && e->scene.thesis.node_slots > 0 &&
           !plt_link_is_leaf(e->scene.thesis.root);
}

static void refit(plt_moving *m, plt_refit_job *job) {
#if PLT_WITH_SUBTREES
    if (m->subtrees.count > 0) {
        plt_subtrees_refit(&m->subtrees, job);
        if (m->is_new) {
            plt_subtrees_are_new(&m->subtrees);
        }
        return;
    }
#endif
    (void)m;
    plt_refit(job);
}

void plt_refit_all(plt_engine *e) {
    plt_moving *m = &e->moving;
    if (!plt_has_nodes(e)) {
        m->box = plt_records_box(plt_records_of(e), 0, e->scene.info.triangles);
        return;
    }
    plt_refit_job job = {.nodes = (plt_node *)(uintptr_t)e->scene.thesis.nodes,
                         .records = e->scene.thesis.records,
                         .root = e->scene.thesis.root,
                         .levels = m->levels,
                         .areas = m->areas};
    refit(m, &job);
    m->box = job.box;
    m->areas = job.areas;
    m->areas_built = m->is_new ? job.areas : m->areas_built;
    m->is_new = 0;
}
#endif

void plt_moved(plt_engine *e) {
    e->moving.moves++;
    if (e->scene.info.triangles > 0) {
        e->scene.box = e->moving.box;
        memcpy(e->scene.info.lo, e->scene.box.lo, sizeof e->scene.info.lo);
        memcpy(e->scene.info.hi, e->scene.box.hi, sizeof e->scene.info.hi);
    }
    plt_grid_room_fill(e);
}

int plt_move_refused(const plt_engine *e, const float (*corners)[9], uint32_t count,
                     plt_fault *fault) {
    plt_fault_set(fault, PLT_OK, 0, "no fault");
    if (!e->options.movable) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0, "the scene was not opened to be moved");
    }
    if (plt_has_moving_blocks(e)) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0,
                             "triangles of compact blocks move as the image's frames say alone");
    }
    if (plt_is_over_vertices(e)) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0,
                             "the scene has no records that could be moved, its frames can be "
                             "shown (plt_options.records)");
    }
    const uint32_t refused = plt_corners_refused(corners, count);
    return refused == count ? PLT_OK
                            : plt_fault_set(fault, PLT_ERR_ARGUMENT, refused,
                                            "a corner is not a number, or beyond 2^40");
}

int plt_move(plt_engine *e, const float (*corners)[9], plt_fault *fault) {
    const uint32_t count = e->scene.info.triangles;
    const int status = plt_move_refused(e, corners, count, fault);
#if PLT_WITH_THESIS
    if (status == PLT_OK) {
        e->rendering.done = 1;
        plt_rebuild_before_move(e, 0);
        plt_corners_put(plt_records_of(e), count, corners);
        plt_refit_all(e);
        plt_moved(e);
    }
#endif
    return status;
}

void plt_motion_get(const plt_engine *e, plt_motion *to) {
    const plt_moving *m = &e->moving;
    const plt_motion none = {0};
    *to = none;
    to->degradation = plt_degradation(m);
    to->growth = plt_growth(m);
    to->moves = m->moves;
#if PLT_WITH_VERTICES
    to->over_vertices = (uint8_t)plt_is_over_vertices(e);
    to->is_beside = m->beside.nodes != NULL;
#endif
#if PLT_WITH_REBUILD
    to->rebuilds = m->rebuilds;
    to->is_building = m->rebuild.phase != PLT_REBUILD_IDLE;
    to->excess_work = plt_rebuild_excess(e);
    to->build_work = plt_rebuild_cost(e);
#endif
#if PLT_WITH_SUBTREES
    to->subtrees = m->subtrees.count;
    to->rebuilt = m->rebuilt;
#endif
}
