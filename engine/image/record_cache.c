/* record_cache - see record_cache.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/image/record_cache.h"

#include <string.h>

#include "engine/image/fetch.h"
#include "engine/planelet_crc32.h"

plt_record_cache *plt_record_cache_init(void *memory, const plt_source *source, uint32_t offset,
                                        uint32_t record_bytes, uint32_t records) {
    plt_record_cache *c = memory;
    memset(c, 0, sizeof *c);
    c->source = source;
    c->offset = offset;
    c->record_bytes = record_bytes;
    c->records = records;
    c->lines = (unsigned char *)memory + sizeof *c;
    return c;
}

/* Zeros where the source failed; after that it is not asked again. */
static void read(plt_record_cache *c, uint32_t offset, unsigned char *to, uint32_t count) {
    if (c->status == PLT_OK) {
        c->status = plt_fetch(c->source, c->offset + offset, to, count, &c->fault);
    }
    if (c->status != PLT_OK) {
        memset(to, 0, count);
    }
}

const unsigned char *plt_record_cache_find(plt_record_cache *c, uint32_t index) {
    const uint32_t line = index / PLT_RECORD_CACHE_LINE_RECORDS;
    const uint32_t first = line * PLT_RECORD_CACHE_LINE_RECORDS,
                   slot = line % PLT_RECORD_CACHE_LINES;
    unsigned char *at = c->lines + (size_t)slot * PLT_RECORD_CACHE_LINE_RECORDS * c->record_bytes;
    if (c->held[slot] != line + 1) {
        const uint32_t left = c->records - first;
        const uint32_t here =
            left < PLT_RECORD_CACHE_LINE_RECORDS ? left : PLT_RECORD_CACHE_LINE_RECORDS;
        read(c, first * c->record_bytes, at, here * c->record_bytes);
        c->held[slot] = line + 1;
    }
    return at + (index - first) * c->record_bytes;
}

uint32_t plt_record_cache_crc(plt_record_cache *c, uint32_t count) {
    const uint32_t most = PLT_RECORD_CACHE_LINES * PLT_RECORD_CACHE_LINE_RECORDS * c->record_bytes;
    uint32_t crc = 0;
    memset(c->held, 0, sizeof c->held);
    for (uint32_t done = 0; done < count;) {
        const uint32_t now = count - done < most ? count - done : most;
        read(c, done, c->lines, now);
        crc = plt_crc32(crc, c->lines, now);
        done += now;
    }
    return crc;
}
