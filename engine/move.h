/* move - what the public calls of motion share
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOVE_H
#define PLT_MOVE_H

#include "engine/engine.h"
#include "engine/scene/parts.h"
#include "engine/tree/record.h"

/* Of a movable scene. */
plt_record *plt_records_of(plt_engine *engine);

/* Its tree is more than a list. */
int plt_has_nodes(const plt_engine *engine);

/* The scene is of compact blocks: a movable one has frames. */
static inline int plt_has_moving_blocks(const plt_engine *engine) {
    return PLT_WITH_BLOCK_MOTION && (!PLT_WITH_THESIS || plt_has_blocks(engine->scene.format));
}

/* PLT_ERR_ARGUMENT: `fault` says why triangles cannot move there. */
int plt_move_refused(const plt_engine *engine, const float (*corners)[9], uint32_t count,
                     plt_fault *fault);

/* They have: the scene's box is that of its tree. */
void plt_moved(plt_engine *engine);

/* Boxes of all nodes and of the root, and their spread. The scene's box stays. */
void plt_refit_all(plt_engine *engine);

#if PLT_WITH_VERTICES
/* Records are made at each visit of a leaf; the scene shows frames alone. */
int plt_is_over_vertices(const plt_engine *engine);

/* Once a sequence is open: vertices are there twice, and a frame has to be shown. */
void plt_beside_start(plt_engine *engine, void *const part[PLT_PARTS_COUNT]);

/* Another frame was asked for. */
void plt_beside_begin(plt_engine *engine);

/* The frame that was asked for has come: goes on with its nodes, beside those that are shown.
 * PLT_MORE or PLT_OK. */
int plt_beside_more(plt_engine *engine, uint32_t blocks);

/* It is shown. */
void plt_beside_put(plt_engine *engine);
#else
static inline int plt_is_over_vertices(const plt_engine *engine) {
    (void)engine;
    return 0;
}

static inline void plt_beside_begin(const plt_engine *engine) {
    (void)engine;
}

static inline int plt_beside_more(const plt_engine *engine, uint32_t blocks) {
    (void)engine;
    (void)blocks;
    return PLT_OK;
}

static inline void plt_beside_put(const plt_engine *engine) {
    (void)engine;
}
#endif

#if PLT_WITH_REBUILD
/* Records are about to change: the work of the tree as it is counts, and a new tree that has
 * collected corners becomes the scene's. `some`: not all records, so it has to be refitted. */
void plt_rebuild_before_move(plt_engine *engine, int some);

/* Work since the last rebuild that a new tree would have saved, and what such a tree costs. */
uint64_t plt_rebuild_excess(const plt_engine *engine);
uint64_t plt_rebuild_cost(const plt_engine *engine);

/* Statistics are about to become 0. */
void plt_rebuild_before_reset(plt_engine *engine);
#else
static inline void plt_rebuild_before_move(const plt_engine *engine, int some) {
    (void)engine;
    (void)some;
}
#endif

#endif
