/* whitted_room - the parts of the arena for lights, mirrors and glass
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WHITTED_ROOM_H
#define PLT_WHITTED_ROOM_H

#include "engine/engine.h"

#if PLT_WITH_WHITTED
/* Lays it out, if it is asked for, once all that runs was cut. `header` may be NULL if it is not.
 */
int plt_whitted_room_set(plt_engine *e, const plt_header *header, void *const part[PLT_PARTS_COUNT],
                         plt_fault *fault);
#else
static inline int plt_whitted_room_set(const plt_engine *e, const plt_header *header,
                                       void *const part[PLT_PARTS_COUNT], const plt_fault *fault) {
    (void)e;
    (void)header;
    (void)part;
    (void)fault;
    return PLT_OK;
}
#endif

#endif
