/* room - see room.h
 *
 * SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "tests/reference/room.h"

#include <stdlib.h>

#include "engine/planelet.h"

void *room_get(size_t bytes) {
    void *room;
    return posix_memalign(&room, PLT_ALIGN, bytes) == 0 ? room : NULL;
}
