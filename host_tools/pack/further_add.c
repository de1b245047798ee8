/* further_add - see further_add.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/further_add.h"

#include <string.h>

#include "engine/base/bytes.h"
#include "engine/image/further.h"
#include "engine/image/header_at.h"
#include "engine/planelet_crc32.h"
#include "host_tools/base/heap.h"

/* Sections that are there, and where their table begins, or will. */
typedef struct before {
    uint32_t count, table, bytes; /* bytes: of the table */
} before;

static int read_before(const packed *image, before *b) {
    plt_header h;
    plt_fault fault;
    if (plt_header_read(&h, image->bytes, image->size, &fault) != PLT_OK) {
        return -1;
    }
    b->count = h.further_count;
    b->table = h.further_at;
    b->bytes = b->count > 0 ? plt_further_table_bytes(b->count) : 0;
    return b->count < PLT_FURTHER_MOST ? 0 : -1;
}

static void put_entry(unsigned char *to, uint32_t kind, uint32_t offset, uint32_t size,
                      uint32_t crc) {
    plt_put_u32(to, kind);
    plt_put_u32(to + 4, offset);
    plt_put_u32(to + 8, size);
    plt_put_u32(to + 12, crc);
}

/* How many of those that are there have lower kinds; *at: the byte where the last of them ends. */
static uint32_t find_place(const unsigned char *bytes, const before *b, uint32_t kind,
                           uint32_t *at) {
    const unsigned char *entry = bytes + b->table + PLT_FURTHER_HEAD;
    uint32_t i = 0;
    *at = b->table + b->bytes;
    for (; i < b->count && plt_get_u32(entry) < kind; i++, entry += PLT_FURTHER_ENTRY) {
        *at = plt_get_u32(entry + 4) + plt_get_u32(entry + 8);
    }
    return i;
}

/* The sections that were there move as far as the table has grown, those behind the new one also by
 * that. */
static void put_table(unsigned char *bytes, const unsigned char *old, const before *b,
                      uint32_t place, const unsigned char *added, uint32_t grown) {
    const unsigned char *from = old + b->table + PLT_FURTHER_HEAD;
    unsigned char *table = bytes + b->table, *entry = table + PLT_FURTHER_HEAD;
    uint32_t end = 0;
    for (uint32_t i = 0; i <= b->count; i++, entry += PLT_FURTHER_ENTRY) {
        if (i == place) {
            memcpy(entry, added, PLT_FURTHER_ENTRY);
        } else {
            const uint32_t more = grown + (i > place ? plt_get_u32(added + 8) : 0);
            memcpy(entry, from, PLT_FURTHER_ENTRY);
            plt_put_u32(entry + 4, plt_get_u32(entry + 4) + more);
            from += PLT_FURTHER_ENTRY;
        }
        end = plt_get_u32(entry + 4) + plt_get_u32(entry + 8);
    }
    plt_put_u32(table, plt_further_check(table, plt_further_table_bytes(b->count + 1)));
    plt_put_u32(bytes + PLT_AT_FURTHER, b->count + 1);
    plt_put_u32(bytes + PLT_AT_IMAGE_BYTES, end);
    plt_header_seal(bytes);
}

static int take(packed *image, unsigned char *bytes, uint32_t size, const char *name, fail *f) {
    plt_fault fault;
    heap_drop(image->bytes);
    image->bytes = bytes;
    image->size = size;
    const plt_source source = {.mapped = bytes, .bytes = size};
    return plt_image_info(&source, &image->info, &fault) == PLT_OK
               ? 0
               : fail_set(f, name, "the finished image is refused: %s; please report this",
                          fault.message);
}

int further_add(packed *image, uint32_t kind, const unsigned char *section, uint32_t size,
                const char *name, fail *f) {
    before b;
    if (read_before(image, &b) != 0) {
        return fail_set(f, name, "there is no room for one more section; please report this");
    }
    const uint32_t grown = plt_further_table_bytes(b.count + 1) - b.bytes;
    const uint64_t all = (uint64_t)image->size + grown + size;
    unsigned char *bytes = heap_get_aligned(all);
    if (bytes == NULL) {
        return fail_set(f, name, "out of memory; use a larger machine");
    }
    const uint32_t old = b.table + b.bytes; /* where the sections behind the table begin */
    uint32_t at;
    const uint32_t place = find_place(image->bytes, &b, kind, &at);
    unsigned char entry[PLT_FURTHER_ENTRY];
    put_entry(entry, kind, at + grown, size, plt_crc32(0, section, size));
    memcpy(bytes, image->bytes, old);
    memset(bytes + old, 0, grown);
    memcpy(bytes + old + grown, image->bytes + old, at - old);
    memcpy(bytes + at + grown, section, size);
    memcpy(bytes + at + grown + size, image->bytes + at, image->size - at);
    put_table(bytes, image->bytes, &b, place, entry, grown);
    return take(image, bytes, (uint32_t)all, name, f);
}
