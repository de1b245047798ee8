/* move_some - the public call by which some triangles move
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/fault.h"
#include "engine/engine.h"
#include "engine/move.h"
#include "engine/tree/record_put.h"

/* Of more triangles than this a refit of all is faster. */
static uint32_t few(uint32_t count) {
    return count / 4;
}

static void put_some(plt_engine *e, const uint32_t *ids, const float (*corners)[9],
                     uint32_t count) {
    plt_dirty *d = &e->moving.dirty;
    plt_record *records = plt_records_of(e);
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t place = d->places[ids[i]];
        plt_record_put(&records[place], corners[i]);
        plt_dirty_set(d, place);
    }
}

static void clear_bits(plt_dirty *d, const uint32_t *ids, uint32_t count) {
    for (uint32_t i = 0; i < count; i++) {
        d->bits[d->places[ids[i]] / 32] = 0;
    }
}

int plt_move_some(plt_engine *e, const uint32_t *ids, const float (*corners)[9], uint32_t count,
                  plt_fault *fault) {
    int status = plt_move_refused(e, corners, count, fault);
    if (status == PLT_OK && e->moving.dirty.places == NULL) {
        status = plt_fault_set(fault, PLT_ERR_ARGUMENT, 0,
                               "the scene was not opened for some triangles to be moved");
    }
    for (uint32_t i = 0; i < count && status == PLT_OK; i++) {
        if (ids[i] >= e->scene.info.triangles) {
            status = plt_fault_set(fault, PLT_ERR_ARGUMENT, i, "there is no such triangle");
        }
    }
    if (status != PLT_OK || count == 0) {
        return status;
    }
    e->rendering.done = 1;
    plt_rebuild_before_move(e, 1);
    put_some(e, ids, corners, count);
    if (plt_has_nodes(e) && count <= few(e->scene.info.triangles)) {
        plt_dirty_refit(&e->moving.dirty, &e->scene.thesis, &e->moving.box, &e->moving.areas);
    } else {
        plt_refit_all(e);
    }
    clear_bits(&e->moving.dirty, ids, count);
    plt_moved(e);
    return PLT_OK;
}
