/* beside - frames of a scene whose triangles are numbers of vertices
 *
 * SPDX-License-Identifier: MIT */
#include "engine/engine.h"
#include "engine/move.h"

#if PLT_WITH_VERTICES

/* Leaf links that are refitted in the time that a block of a frame takes. */
enum { LISTS_PER_BLOCK = 4 };

int plt_is_over_vertices(const plt_engine *e) {
    return e->scene.format == PLT_FORMAT_VERTICES;
}

void plt_beside_begin(plt_engine *e) {
    if (e->sequence.is_reading) { /* nodes beside are of the frame that goes */
        e->moving.beside.phase = PLT_BESIDE_IDLE;
    }
}

int plt_beside_more(plt_engine *e, uint32_t blocks) {
    const uint32_t most = UINT32_MAX / LISTS_PER_BLOCK;
    return plt_beside_step(&e->moving.beside, &e->sequence, &e->scene.thesis, &e->scene.vertices,
                           (blocks < most ? blocks : most) * LISTS_PER_BLOCK);
}

void plt_beside_put(plt_engine *e) {
    e->moving.box =
        plt_beside_show(&e->moving.beside, &e->sequence, &e->scene.thesis, &e->scene.vertices);
}

void plt_beside_start(plt_engine *e, void *const part[PLT_PARTS_COUNT]) {
    plt_vertex_lists *lists = &e->scene.vertices;
    const size_t bytes = plt_arena_cut_bytes((size_t)plt_sequence_vertices_bytes(&e->scene.info));
    lists->vertices = e->sequence.vertices;
    lists->vertices.vertex =
        (const plt_frame_vertex *)(const void *)((char *)part[PLT_PART_VERTICES] + bytes);
    plt_beside_set(&e->moving.beside, e->options.beside ? part[PLT_PART_BESIDE] : NULL,
                   &e->scene.thesis, part[PLT_PART_REFIT]);
}

#endif
