/* arena - one block of memory, cut from the front, given back by marks
 *
 * Invariant: used <= bytes, peak >= used, every cut starts at a multiple of
 * PLT_ALIGN. A cut that does not fit changes nothing.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BASE_ARENA_H
#define PLT_BASE_ARENA_H

#include <stddef.h>

typedef struct plt_arena {
    unsigned char *base; /* owned by the board or the caller of plt_open */
    size_t bytes, used, peak;
} plt_arena;

/* `count` rounded up to PLT_ALIGN: what a cut of `count` bytes takes. */
size_t plt_arena_cut_bytes(size_t count);

/* The next `count` bytes, or NULL. Contents are what they were before. */
void *plt_arena_cut(plt_arena *arena, size_t count);

/* Everything cut since `mark` (a former `used`) is free again. */
void plt_arena_release(plt_arena *arena, size_t mark);

#endif
