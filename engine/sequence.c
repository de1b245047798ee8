/* sequence - the public calls that show an image's frames
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/fault.h"
#include "engine/engine.h"
#include "engine/move.h"

int plt_sequence_begin(plt_engine *e, uint32_t frame, plt_fault *fault) {
    plt_fault_set(fault, PLT_OK, 0, "no fault");
    if (frame >= e->sequence.frames) {
        e->sequence.failed = frame;
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0,
                             e->sequence.frames > 0
                                 ? "the image has no such frame"
                                 : "the image has no frames, or was not opened to be moved");
    }
    plt_sequence_seek(&e->sequence, frame);
    plt_beside_begin(e);
    return PLT_OK;
}

static void show(plt_engine *e) {
    if (plt_is_over_vertices(e)) {
        plt_beside_put(e);
        return;
    }
    plt_rebuild_before_move(e, 0);
    plt_vertices_put(plt_records_of(e), e->scene.info.triangles, &e->sequence.vertices);
    plt_refit_all(e);
}

int plt_sequence_step(plt_engine *e, uint32_t blocks, plt_fault *fault) {
    plt_fault_set(fault, PLT_OK, 0, "no fault");
    if (e->sequence.frames == 0 || (!e->sequence.is_reading && e->sequence.at == PLT_FRAME_NONE)) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0, "no frame was begun");
    }
    if (!e->sequence.is_reading) {
        return plt_is_over_vertices(e) ? plt_beside_more(e, blocks) : PLT_OK;
    }
    const int status = plt_sequence_read(&e->sequence, blocks > 0 ? blocks : 1, fault);
    return status == PLT_OK && plt_is_over_vertices(e) ? PLT_MORE : status;
}

int plt_sequence_show(plt_engine *e, uint32_t frame, plt_fault *fault) {
    int status = plt_sequence_begin(e, frame, fault);
    if (status == PLT_OK) {
        status = plt_sequence_read(&e->sequence, UINT32_MAX, fault);
    }
    if (status == PLT_MORE) { /* more blocks than a number counts: never */
        return PLT_ERR_LIMIT;
    }
    if (status == PLT_OK) {
        e->rendering.done = 1;
        show(e);
        plt_moved(e);
    }
    return status;
}

uint32_t plt_sequence_failed(const plt_engine *e) {
    return e->sequence.failed;
}
