/* arena - see arena.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/arena.h"

#include <stdint.h>

#include "engine/planelet.h"

size_t plt_arena_cut_bytes(size_t count) {
    return count > SIZE_MAX - PLT_ALIGN ? SIZE_MAX
                                        : (count + PLT_ALIGN - 1) & ~(size_t)(PLT_ALIGN - 1);
}

void *plt_arena_cut(plt_arena *arena, size_t count) {
    const size_t bytes = plt_arena_cut_bytes(count);
    if (bytes > arena->bytes - arena->used) {
        return NULL;
    }
    unsigned char *cut = arena->base + arena->used;
    arena->used += bytes;
    if (arena->used > arena->peak) {
        arena->peak = arena->used;
    }
    return cut;
}

void plt_arena_release(plt_arena *arena, size_t mark) {
    arena->used = mark;
}
