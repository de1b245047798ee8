/* sequence - the public calls that show an image's frames
 *
 * Of vertices that move, or of matrices that place instances.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/fault.h"
#include "engine/engine.h"
#include "engine/frame_put.h"
#include "engine/instances_room.h"
#include "engine/move.h"

#if PLT_WITH_SEQUENCE

static int vertices_begin(plt_engine *e, uint32_t frame, plt_fault *fault) {
    if (frame >= e->sequence.frames) {
        e->sequence.failed = frame;
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0,
                             e->sequence.frames > 0
                                 ? "the image has no such frame"
                                 : "the image has no frames, or was not opened to be moved");
    }
    if (PLT_WITH_STILLS && plt_is_streamed(e->scene.format)) {
        e->sequence.at = frame; /* there is nothing to be read beforehand */
    } else {
        plt_sequence_seek(&e->sequence, frame);
        plt_beside_begin(e);
    }
    return PLT_OK;
}

static int vertices_read(plt_engine *e, uint32_t blocks, plt_fault *fault) {
    if (e->sequence.frames == 0 || (!e->sequence.is_reading && e->sequence.at == PLT_FRAME_NONE)) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0, "no frame was begun");
    }
    return plt_sequence_read(&e->sequence, blocks, fault);
}

/* Blocks of the frame, and when all of them are there, where there are no records, its tree. */
static int vertices_step(plt_engine *e, uint32_t blocks, plt_fault *fault) {
    const int has_come = !e->sequence.is_reading && e->sequence.at != PLT_FRAME_NONE;
    if (has_come && plt_is_over_vertices(e)) {
        return plt_beside_more(e, blocks);
    }
    const int status = vertices_read(e, blocks, fault);
    return status == PLT_OK && plt_is_over_vertices(e) ? PLT_MORE : status;
}

#endif

#if PLT_WITH_INSTANCES

static int matrices_begin(plt_engine *e, uint32_t frame, plt_fault *fault) {
    if (frame >= e->matrices.frames) {
        e->matrices.failed = frame;
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0,
                             e->matrices.frames > 0 ? "the image has no such frame"
                                                    : "the image has no frames");
    }
    plt_matrices_seek(&e->matrices, frame);
    return PLT_OK;
}

static int matrices_read(plt_engine *e, uint32_t blocks, plt_fault *fault) {
    if (e->matrices.frames == 0 ||
        (!e->matrices.is_reading && e->matrices.at == PLT_MATRICES_NONE)) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0, "no frame was begun");
    }
    return plt_matrices_read(&e->matrices, blocks, fault);
}

#endif

/* CHOSEN(e, instances, vertices): what is called of an engine of one kind or the other, where the
 * build has both. */
#if PLT_WITH_INSTANCES && PLT_WITH_SEQUENCE
#define CHOSEN(e, of_instances, of_vertices)                                                       \
    ((e)->scene.format == PLT_FORMAT_INSTANCES ? (of_instances) : (of_vertices))
#elif PLT_WITH_INSTANCES
#define CHOSEN(e, of_instances, of_vertices) (of_instances)
#else
#define CHOSEN(e, of_instances, of_vertices) (of_vertices)
#endif

int plt_sequence_begin(plt_engine *e, uint32_t frame, plt_fault *fault) {
    plt_fault_set(fault, PLT_OK, 0, "no fault");
    return CHOSEN(e, matrices_begin(e, frame, fault), vertices_begin(e, frame, fault));
}

int plt_sequence_step(plt_engine *e, uint32_t blocks, plt_fault *fault) {
    plt_fault_set(fault, PLT_OK, 0, "no fault");
    const uint32_t most = blocks > 0 ? blocks : 1;
    return CHOSEN(e, matrices_read(e, most, fault), vertices_step(e, most, fault));
}

int plt_sequence_show(plt_engine *e, uint32_t frame, plt_fault *fault) {
    int status = plt_sequence_begin(e, frame, fault);
    if (status == PLT_OK) {
        status =
            CHOSEN(e, matrices_read(e, UINT32_MAX, fault), vertices_read(e, UINT32_MAX, fault));
    }
    if (status == PLT_MORE) { /* more blocks than a number counts: never */
        return PLT_ERR_LIMIT;
    }
    return status == PLT_OK
               ? CHOSEN(e, plt_instances_show(e, fault), plt_frame_put(e, frame, fault))
               : status;
}

uint32_t plt_sequence_failed(const plt_engine *e) {
    return CHOSEN(e, e->matrices.failed, e->sequence.failed);
}
