/* instances_room - the parts of the arena that instances lie in
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_INSTANCES_ROOM_H
#define PLT_INSTANCES_ROOM_H

#include "engine/engine.h"

#if PLT_WITH_INSTANCES
/* Bytes of instances, their boxes and inverses, and of the tree over them. */
uint64_t plt_instances_room_bytes(const plt_info *info);

/* Places the instances of frame 0, where the scene has some, once all that runs was cut. */
int plt_instances_room_set(plt_engine *e, const plt_header *header,
                           void *const part[PLT_PARTS_COUNT], plt_fault *fault);

/* Places all instances where matrices say, or, if `matrix` is NULL, those of the frame that has
 * come. The count of instances; or the first whose matrix is refused, and nothing has changed. */
uint32_t plt_instances_place(plt_engine *e, const float (*matrix)[PLT_MATRIX_FLOATS]);

/* The frame that has come is shown; or refused, and nothing has changed. */
int plt_instances_show(plt_engine *e, plt_fault *fault);
#else
static inline int plt_instances_room_set(plt_engine *e, const plt_header *header,
                                         void *const part[PLT_PARTS_COUNT], plt_fault *fault) {
    (void)e;
    (void)header;
    (void)part;
    (void)fault;
    return PLT_OK;
}
#endif

#endif
