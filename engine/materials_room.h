/* materials_room - the part of the arena for materials
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MATERIALS_ROOM_H
#define PLT_MATERIALS_ROOM_H

#include "engine/engine.h"

#if PLT_WITH_MATERIALS
/* Reads those of the image, if it has some, into `to`: where they are mapped, or copied to the
 * arena. R13, R19. */
int plt_materials_room_set(const plt_engine *e, const plt_header *header,
                           void *const part[PLT_PARTS_COUNT], plt_materials *to, plt_fault *fault);
#endif

#endif
