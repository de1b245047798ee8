/* record_cache - see record_cache.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/image/record_cache.h"

#include <string.h>

#include "engine/image/fetch.h"
#include "engine/planelet_crc32.h"

plt_record_cache *plt_record_cache_init(void *memory, const plt_source *source, uint32_t offset,
                                        uint32_t record_bytes, uint32_t records) {
    plt_record_cache *w = memory;
    memset(w, 0, sizeof *w);
    w->source = source;
    w->offset = offset;
    w->record_bytes = record_bytes;
    w->records = records;
    w->lines = (unsigned char *)memory + sizeof *w;
    return w;
}

/* Zeros where the source failed; after that it is not asked again. */
static void read(plt_record_cache *w, uint32_t offset, unsigned char *to, uint32_t count) {
    if (w->status == PLT_OK) {
        w->status = plt_fetch(w->source, w->offset + offset, to, count, &w->fault);
    }
    if (w->status != PLT_OK) {
        memset(to, 0, count);
    }
}

const unsigned char *plt_record_cache_find(plt_record_cache *w, uint32_t number) {
    const uint32_t line = number / PLT_RECORD_CACHE_LINE_RECORDS;
    const uint32_t first = line * PLT_RECORD_CACHE_LINE_RECORDS,
                   place = line % PLT_RECORD_CACHE_LINES;
    unsigned char *at = w->lines + (size_t)place * PLT_RECORD_CACHE_LINE_RECORDS * w->record_bytes;
    if (w->held[place] != line + 1) {
        const uint32_t left = w->records - first;
        const uint32_t here =
            left < PLT_RECORD_CACHE_LINE_RECORDS ? left : PLT_RECORD_CACHE_LINE_RECORDS;
        read(w, first * w->record_bytes, at, here * w->record_bytes);
        w->held[place] = line + 1;
    }
    return at + (number - first) * w->record_bytes;
}

uint32_t plt_record_cache_crc(plt_record_cache *w, uint32_t count) {
    const uint32_t most = PLT_RECORD_CACHE_LINES * PLT_RECORD_CACHE_LINE_RECORDS * w->record_bytes;
    uint32_t crc = 0;
    memset(w->held, 0, sizeof w->held);
    for (uint32_t done = 0; done < count;) {
        const uint32_t now = count - done < most ? count - done : most;
        read(w, done, w->lines, now);
        crc = plt_crc32(crc, w->lines, now);
        done += now;
    }
    return crc;
}
