/* guarded - an arena with bytes behind it that nobody may write, and the source of its image
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_GUARDED_H
#define REFERENCE_GUARDED_H

#include <stdlib.h>
#include <string.h>

#include "board/fake/fake.h"
#include "tests/reference/rig.h"

enum { GUARDED_BYTES = 64, GUARDED_PATTERN = 0x5A };

/* The image, mapped or through `link`. */
static inline plt_source guarded_source(fake_link *link, const packed *image, int is_mapped) {
    link->image = image->bytes;
    link->bytes = image->size;
    return is_mapped ? rig_source(image) : fake_source(link);
}

/* For an engine that reads through `link`, if it does; free() it. */
static inline unsigned char *guarded_arena(fake_link *link, size_t bytes) {
    unsigned char *arena = aligned_alloc(PLT_ALIGN, bytes + GUARDED_BYTES);
    memset(arena, GUARDED_PATTERN, bytes + GUARDED_BYTES);
    link->arena = arena;
    link->arena_bytes = bytes;
    return arena;
}

/* 1: nothing was written behind it. NULL is no arena. */
static inline int guarded_whole(const unsigned char *arena, size_t bytes) {
    int whole = 1;
    for (unsigned i = 0; i < GUARDED_BYTES && arena != NULL; i++) {
        whole &= arena[bytes + i] == GUARDED_PATTERN;
    }
    return whole;
}

#endif
