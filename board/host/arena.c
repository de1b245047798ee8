/* arena - the host's one static arena
 *
 * SPDX-License-Identifier: MIT */
#include "board/host/host.h"

static _Alignas(4096) unsigned char arena[PLT_BOARD_ARENA_BYTES];

void *host_arena(size_t bytes) {
    return bytes <= sizeof arena ? arena : NULL;
}

size_t host_arena_bytes(void) {
    return sizeof arena;
}
