/* frame_put - see frame_put.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/frame_put.h"

#include "engine/engine.h"
#include "engine/move.h"
#include "engine/shade/beam.h"
#include "engine/trace/block_entry.h"

#if PLT_WITH_SEQUENCE

#if PLT_WITH_BLOCK_MOTION
/* Blocks lie in the arena, as all does that moves. What was opened of them has other bounds now. */
static void put_blocks(plt_engine *e) {
    plt_block_tree *t = &e->scene.compact;
    const plt_vertices *v = &e->sequence.vertices;
    const plt_block_numbers n = {v->vertex, v->topology, v->index_bits};
    plt_block_refit_all(&e->moving.blocks, t, (unsigned char *)(uintptr_t)t->bytes,
                        (unsigned char *)(uintptr_t)t->ids.bytes, &n);
    plt_lattice_to_box(&t->lattice, &t->box, &e->moving.box);
    plt_block_state_init(e->traversal.state);
    plt_moved(e);
}
#endif

#if PLT_WITH_STILLS
/* Nothing of it is in the store. */
static void begin_stream(plt_engine *e) {
#if PLT_WITH_GROUPS
    plt_state_init(&e->traversal);
#else
    plt_beam_state_init(&e->traversal);
#endif
}

/* The scene's box is that of the root, which is fetched for it. */
static int find_box(plt_engine *e, plt_fault *fault) {
    plt_block_tree *t = &e->scene.compact;
    plt_stream *s = e->traversal.state;
    const int status = plt_stream_open(s, t->root, plt_stream_end(t->used));
    if (status != PLT_OK) {
        *fault = s->fetcher.fault;
        return status;
    }
    plt_block_bounds(&s->current->opened.block, t->lattice.bits, &t->box);
    s->tree.box = t->box;
    return PLT_OK;
}

/* Blocks of another frame lie in another place, and are as large. */
static int put_still(plt_engine *e, uint32_t frame, plt_fault *fault) {
    plt_block_tree *t = &e->scene.compact;
    const plt_block_tree was = *t;
    const plt_stream_image image = e->scene.stream;
    for (int a = 0; a < 3; a++) { /* until its own is known */
        t->box.lo[a] = 0;
        t->box.hi[a] = plt_low_bits(t->lattice.bits);
    }
    t->salt = plt_still_salt(frame);
    e->scene.stream.blocks_at = image.stills_at + frame * t->used;
    begin_stream(e);
    const int status = find_box(e, fault);
    if (status != PLT_OK) {
        *t = was;
        e->scene.stream = image;
        begin_stream(e);
        e->sequence.failed = frame;
        return status;
    }
    plt_lattice_to_box(&t->lattice, &t->box, &e->moving.box);
    plt_moved(e);
    return PLT_OK;
}
#endif

#if PLT_WITH_THESIS
static void put_records(plt_engine *e) {
    plt_rebuild_before_move(e, 0);
    plt_vertices_put(plt_records_of(e), e->scene.info.triangles, &e->sequence.vertices);
    plt_refit_all(e);
    plt_moved(e);
}
#endif

int plt_frame_put(plt_engine *e, uint32_t frame, plt_fault *fault) {
    e->rendering.done = 1;
#if PLT_WITH_STILLS
    if (plt_is_streamed(e->scene.format)) {
        return put_still(e, frame, fault);
    }
#endif
    (void)frame;
    (void)fault;
#if PLT_WITH_BLOCK_MOTION
    if (plt_has_moving_blocks(e)) {
        put_blocks(e);
        return PLT_OK;
    }
#endif
    if (plt_is_over_vertices(e)) {
        plt_beside_put(e);
        plt_moved(e);
        return PLT_OK;
    }
#if PLT_WITH_THESIS
    put_records(e);
#endif
    return PLT_OK;
}

#endif
