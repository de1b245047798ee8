/* record_cache - a direct-mapped cache of records of an image
 *
 * For a scene that is built straight from a source that is not mapped: the builder
 * reads triangles in no order, again and again, and there is no room for all of
 * them. Eight records that lie together are a line; line i goes to slot
 * i % PLT_RECORD_CACHE_LINES.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_IMAGE_RECORD_CACHE_H
#define PLT_IMAGE_RECORD_CACHE_H

#include <stddef.h>

#include "engine/planelet.h"

#define PLT_RECORD_CACHE_LINES 32u
#define PLT_RECORD_CACHE_LINE_RECORDS 8u

typedef struct plt_record_cache {
    const plt_source *source;
    uint32_t offset;       /* of record 0 in the source */
    uint32_t record_bytes; /* 1 .. 64 */
    uint32_t records;
    int status; /* PLT_OK, or what the source failed with; stays */
    plt_fault fault;
    uint32_t held[PLT_RECORD_CACHE_LINES]; /* index of the line + 1; 0: none */
    unsigned char *lines;                  /* behind the structure */
} plt_record_cache;

/* Bytes of a cache of such records, all that it takes. */
static inline size_t plt_record_cache_bytes(uint32_t record_bytes) {
    return sizeof(plt_record_cache) +
           (size_t)PLT_RECORD_CACHE_LINES * PLT_RECORD_CACHE_LINE_RECORDS * record_bytes;
}

/* Lays a cache out in `memory`, plt_record_cache_bytes of it, aligned to PLT_ALIGN. */
plt_record_cache *plt_record_cache_init(void *memory, const plt_source *source, uint32_t offset,
                                        uint32_t record_bytes, uint32_t records);

/* Record `index` (below `records`), valid until the next call. When the source fails,
 * now or before, zeros, and `status` says so. */
const unsigned char *plt_record_cache_find(plt_record_cache *cache, uint32_t index);

/* CRC-32 of `count` bytes from record 0 on, read once through the cache. */
uint32_t plt_record_cache_crc(plt_record_cache *cache, uint32_t count);

#endif
