/* spare - the part of the arena that the engine does not have, and whether it stays untouched
 *
 * plt_arena_used and plt_arena_peak say what the engine cut from its arena; this looks at the
 * bytes. The spare ones get a pattern once the scene is open, and the highest that has changed
 * since is where the arena was used to.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_SPARE_H
#define PLT_BOARD_SPARE_H

#include <stddef.h>

typedef struct spare {
    unsigned char *arena;
    size_t used, bytes; /* the pattern lies in used .. bytes - 1 of it */
} spare;

void spare_fill(const spare *s);

/* Bytes from the arena's start to the last that has changed; s->used: none has. */
size_t spare_touched(const spare *s);

#endif
