/* window - records of an image that stay where they are, some of them at hand
 *
 * For a scene that is built straight from a source that is not mapped: the builder
 * looks triangles up in no order, over and over, and there is no room for all of
 * them. Eight records that lie together are a line; each has one place among
 * PLT_WINDOW_LINES, by its number.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MEMORY_WINDOW_H
#define PLT_MEMORY_WINDOW_H

#include <stddef.h>

#include "engine/planelet.h"

#define PLT_WINDOW_LINES 32u
#define PLT_WINDOW_LINE_RECORDS 8u

typedef struct plt_window {
    const plt_source *source;
    uint32_t offset;       /* of record 0 in the source */
    uint32_t record_bytes; /* 1 .. 64 */
    uint32_t records;
    int status; /* PLT_OK, or what the source failed with; stays */
    plt_fault fault;
    uint32_t held[PLT_WINDOW_LINES]; /* number of the line + 1; 0: none */
    unsigned char *lines;            /* behind the structure */
} plt_window;

/* Bytes of a window on such records, which may be given back with it. */
static inline size_t plt_window_bytes(uint32_t record_bytes) {
    return sizeof(plt_window) + (size_t)PLT_WINDOW_LINES * PLT_WINDOW_LINE_RECORDS * record_bytes;
}

/* Lays a window out in `memory`, plt_window_bytes of it, aligned to PLT_ALIGN. */
plt_window *plt_window_begin(void *memory, const plt_source *source, uint32_t offset,
                             uint32_t record_bytes, uint32_t records);

/* Record `number` (below `records`), until the next call. When the source fails,
 * now or before, zeros, and `status` tells. */
const unsigned char *plt_window_find(plt_window *window, uint32_t number);

/* CRC-32 of `count` bytes from record 0 on, read once through the window. */
uint32_t plt_window_crc(plt_window *window, uint32_t count);

#endif
