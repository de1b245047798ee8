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

/* Sections that are there, where their table begins, or will, and what goes before the new one. */
typedef struct before {
    uint32_t count, table, bytes; /* bytes: of the table */
    uint32_t lower, at;           /* sections of lower kinds, and where they end */
} before;

static int read_before(const packed *image, uint32_t kind, before *b) {
    plt_header h;
    plt_fault fault;
    if (plt_header_read(&h, image->bytes, image->size, &fault) != PLT_OK) {
        return -1;
    }
    b->count = h.further_count;
    b->table = h.further_at;
    b->bytes = b->count > 0 ? plt_further_table_bytes(b->count) : 0;
    b->lower = 0;
    b->at = b->table + b->bytes;
    const unsigned char *entry = image->bytes + b->table + PLT_FURTHER_HEAD;
    for (; b->lower < b->count && plt_get_u32(entry) < kind; entry += PLT_FURTHER_ENTRY) {
        b->at += plt_get_u32(entry + 8);
        b->lower++;
    }
    return b->count < PLT_FURTHER_MOST ? 0 : -1;
}

static void put_entry(unsigned char *to, uint32_t kind, uint32_t offset, uint32_t size,
                      uint32_t crc) {
    plt_put_u32(to, kind);
    plt_put_u32(to + 4, offset);
    plt_put_u32(to + 8, size);
    plt_put_u32(to + 12, crc);
}

/* The sections that were there move as far as the table has grown, and those of higher kinds by the
 * new one, too. */
static void put_table(unsigned char *bytes, const before *b, uint32_t grown, uint32_t kind,
                      uint32_t size, uint32_t end) {
    unsigned char *table = bytes + b->table, *entries = table + PLT_FURTHER_HEAD;
    const uint32_t at = b->at + grown;
    for (uint32_t i = b->count; i-- > 0;) {
        unsigned char *from = entries + i * PLT_FURTHER_ENTRY;
        unsigned char *to = from + (i < b->lower ? 0 : PLT_FURTHER_ENTRY);
        memmove(to, from, PLT_FURTHER_ENTRY);
        plt_put_u32(to + 4, plt_get_u32(to + 4) + grown + (i < b->lower ? 0 : size));
    }
    put_entry(entries + b->lower * PLT_FURTHER_ENTRY, kind, at, size,
              plt_crc32(0, bytes + at, size));
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
    if (read_before(image, kind, &b) != 0) {
        return fail_set(f, name, "there is no room for one more section; please report this");
    }
    const uint32_t grown = plt_further_table_bytes(b.count + 1) - b.bytes;
    const uint64_t all = (uint64_t)image->size + grown + size;
    unsigned char *bytes = heap_get_aligned(all);
    if (bytes == NULL) {
        return fail_set(f, name, "out of memory; use a larger machine");
    }
    const uint32_t old = b.table + b.bytes; /* where the sections behind the table begin */
    memcpy(bytes, image->bytes, old);
    memset(bytes + old, 0, grown);
    memcpy(bytes + old + grown, image->bytes + old, b.at - old);
    memcpy(bytes + b.at + grown, section, size);
    memcpy(bytes + b.at + grown + size, image->bytes + b.at, image->size - b.at);
    put_table(bytes, &b, grown, kind, size, (uint32_t)all);
    return take(image, bytes, (uint32_t)all, name, f);
}
