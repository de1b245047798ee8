/* motion_room - see motion_room.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion_room.h"

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/header_at.h"
#include "engine/layout.h"
#include "engine/move.h"

#if PLT_WITH_MOTION

#if PLT_WITH_SUBTREES
/* The records, nodes and scratch of one subtree, then what is kept of all. */
static void start_subtrees(plt_engine *e, uint32_t most_nodes, unsigned char *part) {
    plt_rebuild *r = &e->moving.rebuild;
    const plt_info *info = &e->scene.info;
    const uint32_t most = e->options.rebuild_most;
    const uint32_t room = plt_subtree_room(info->triangles, most_nodes, most);
    const uint32_t triangles = plt_subtree_triangles(info->triangles, most);
    unsigned char *nodes = part + plt_arena_cut_bytes((size_t)triangles * PLT_RECORD_BYTES);
    unsigned char *scratch = nodes + (size_t)room * PLT_NODE_BYTES;
    r->records = (plt_record *)(void *)part;
    r->nodes = (plt_node *)(void *)nodes;
    r->build.scratch = scratch;
    r->build.scratch_bytes = (size_t)plt_layout_part_scratch(room);
    e->moving.subtrees.at = (plt_subtree *)(void *)(scratch + r->build.scratch_bytes);
    plt_subtrees_find(&e->moving.subtrees, &e->scene.thesis, most, info->leaf_triangles, room,
                      scratch);
}
#endif

#if PLT_WITH_REBUILD
/* The records, nodes and scratch of a second tree, or of a part of one. */
static void start_rebuilds(plt_engine *e, const plt_opening *o, uint32_t most_nodes,
                           void *const part[PLT_PARTS_COUNT]) {
    plt_rebuild *r = &e->moving.rebuild;
    r->refit.levels = e->moving.levels;
#if PLT_WITH_MOVE_SOME
    r->places = e->moving.dirty.places;
#endif
#if PLT_WITH_SUBTREES
    if (o->layout->bytes[PLT_PART_REBUILD] > 0 && e->options.rebuild_most > 0) {
        start_subtrees(e, most_nodes, part[PLT_PART_REBUILD]);
        return;
    }
#else
    (void)most_nodes;
#endif
    if (o->layout->bytes[PLT_PART_REBUILD] > 0) {
        const size_t records =
            plt_arena_cut_bytes((size_t)e->scene.info.triangles * PLT_RECORD_BYTES);
        const size_t nodes = (size_t)r->room * PLT_NODE_BYTES;
        r->records = part[PLT_PART_REBUILD];
        r->nodes = (plt_node *)(void *)((char *)part[PLT_PART_REBUILD] + records);
        r->old_room =
            e->scene.info.node_slots + (uint32_t)(o->layout->bytes[PLT_PART_ROOM] / PLT_NODE_BYTES);
        r->build.scratch = (char *)part[PLT_PART_REBUILD] + records + nodes;
        r->build.scratch_bytes = o->layout->bytes[PLT_PART_REBUILD] - records - nodes;
    }
}
#endif

#if PLT_WITH_MOVE_SOME
/* Some triangles can move: where each is. */
static int start_some(plt_engine *e, const plt_opening *o, void *const part[PLT_PARTS_COUNT]) {
    plt_dirty *d = &e->moving.dirty;
    const uint32_t count = e->scene.info.triangles;
    if (e->options.moves_some) {
        const size_t bytes = plt_arena_cut_bytes((size_t)plt_dirty_bytes(count));
        d->places = part[PLT_PART_DIRTY];
        d->bits = d->places + count;
        d->levels = (plt_dirty_level *)(void *)((char *)part[PLT_PART_DIRTY] + bytes);
#if PLT_WITH_SUBTREES
        d->subtrees = &e->moving.subtrees;
#endif
        if (!plt_dirty_find(d, plt_records_of(e), count)) {
            return plt_fault_set(o->fault, PLT_ERR_ARGUMENT, 0,
                                 "two triangles have one id: they can only be moved together");
        }
    }
    return PLT_OK;
}
#endif

#if PLT_WITH_BLOCK_MOTION
/* Compact blocks that move: where each is. */
static int start_blocks(plt_engine *e, const plt_opening *o, void *const part[PLT_PARTS_COUNT]) {
    plt_block_refit_open(&e->moving.blocks, part[PLT_PART_BLOCKS], &e->scene.compact);
    if (e->moving.blocks.vertices != e->scene.info.block_vertices) {
        return plt_broken(o->fault, PLT_I24_TOPOLOGY, PLT_AT_BLOCK_VERTICES,
                          "the header's count of vertices is not the blocks'");
    }
    return PLT_OK;
}
#endif

#if PLT_WITH_THESIS
/* What a refit needs, and how good the tree is at first. */
static int start_records(plt_engine *e, const plt_opening *o, uint32_t most_nodes,
                         void *const part[PLT_PARTS_COUNT]) {
    plt_moving *m = &e->moving;
    int status = PLT_OK;
    m->levels = part[PLT_PART_REFIT];
    m->is_new = 1;
    m->areas.scale = plt_areas_scale(&e->scene.box);
    m->areas.is_wanted = e->options.rebuild;
#if PLT_WITH_MOVE_SOME
    status = start_some(e, o, part);
#endif
#if PLT_WITH_REBUILD
    start_rebuilds(e, o, most_nodes, part);
#endif
    (void)o;
    (void)most_nodes;
    plt_refit_all(e);
    return status;
}
#endif

int plt_motion_room_set(plt_engine *e, const plt_opening *o, uint32_t most_nodes,
                        void *const part[PLT_PARTS_COUNT]) {
    if (!e->options.movable) {
        return PLT_OK;
    }
#if PLT_WITH_BLOCK_MOTION
    if (plt_has_moving_blocks(e)) {
        return plt_is_streamed(e->scene.format) ? PLT_OK : start_blocks(e, o, part);
    }
#endif
#if PLT_WITH_THESIS
    return plt_is_over_vertices(e) ? PLT_OK : start_records(e, o, most_nodes, part);
#else
    (void)most_nodes;
    return PLT_OK;
#endif
}

#if PLT_WITH_SEQUENCE
#if PLT_WITH_VERTICES
/* The first frame, which records would have. */
static int show_first(plt_engine *e, plt_fault *fault) {
    plt_sequence_seek(&e->sequence, 0);
    plt_beside_begin(e);
    const int status = plt_sequence_read(&e->sequence, UINT32_MAX, fault);
    if (status == PLT_OK) {
        plt_beside_put(e);
        plt_moved(e);
    }
    return status;
}
#endif

int plt_motion_room_sequence(plt_engine *e, const plt_header *header,
                             void *const part[PLT_PARTS_COUNT], plt_fault *fault) {
    if (e->options.movable && plt_is_streamed(e->scene.format)) {
        e->sequence.frames = e->scene.info.frames;
        e->sequence.at = PLT_FRAME_NONE;
    } else if (e->options.movable && header != NULL && header->info.frames > 0) {
        const int is_mapped = e->source.mapped != NULL;
        const plt_sequence_room room = {.topology = is_mapped ? NULL : part[PLT_PART_TOPOLOGY],
                                        .offsets = is_mapped ? NULL : part[PLT_PART_OFFSETS],
                                        .window = is_mapped ? NULL : part[PLT_PART_WINDOW],
                                        .vertex = part[PLT_PART_VERTICES]};
        int status = plt_sequence_open(&e->sequence, header, &e->source, &room, fault);
#if PLT_WITH_VERTICES
        if (status == PLT_OK && plt_is_over_vertices(e)) {
            plt_beside_start(e, part);
            status = show_first(e, fault);
        }
#endif
        return status;
    }
    return PLT_OK;
}
#endif

#endif
