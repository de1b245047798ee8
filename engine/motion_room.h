/* motion_room - the parts of the arena that triangles which move take
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_ROOM_H
#define PLT_MOTION_ROOM_H

#include "engine/engine.h"

#if PLT_WITH_MOTION
/* Once all that runs was cut: what refits, moves of some triangles and rebuilds need, and where the
 * image's triangles are. `most_nodes`: of a tree that the arena has room for. PLT_ERR_ARGUMENT: two
 * triangles have one id, and some are to be moved. PLT_ERR_IMAGE: blocks that move have other
 * vertices than the header says. */
int plt_motion_room_set(plt_engine *e, const plt_opening *o, uint32_t most_nodes,
                        void *const part[PLT_PARTS_COUNT]);
#else
static inline int plt_motion_room_set(plt_engine *e, const plt_opening *o, uint32_t most_nodes,
                                      void *const part[PLT_PARTS_COUNT]) {
    (void)e;
    (void)o;
    (void)most_nodes;
    (void)part;
    return PLT_OK;
}
#endif

#if PLT_WITH_SEQUENCE
/* And what frames need. `header`: of an image that is opened in one step, as all that have a
 * sequence are. */
int plt_motion_room_sequence(plt_engine *e, const plt_header *header,
                             void *const part[PLT_PARTS_COUNT], plt_fault *fault);
#else
static inline int plt_motion_room_sequence(plt_engine *e, const plt_header *header,
                                           void *const part[PLT_PARTS_COUNT], plt_fault *fault) {
    (void)e;
    (void)header;
    (void)part;
    (void)fault;
    return PLT_OK;
}
#endif

#endif
