/* surface_room - the parts of the arena that normals and colours lie in
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SURFACE_ROOM_H
#define PLT_SURFACE_ROOM_H

#include "engine/engine.h"

#if PLT_WITH_SURFACE
/* Reads the image's, if options ask for it, once all that runs was cut: R13, R18. */
int plt_surface_room_set(plt_engine *e, const plt_header *header, void *const part[PLT_PARTS_COUNT],
                         plt_fault *fault);
#else
static inline int plt_surface_room_set(plt_engine *e, const plt_header *header,
                                       void *const part[PLT_PARTS_COUNT], plt_fault *fault) {
    (void)e;
    (void)header;
    (void)part;
    (void)fault;
    return PLT_OK;
}
#endif

#endif
