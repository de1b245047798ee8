/* surface_pages - see surface_pages.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/surface/surface_pages.h"

#if PLT_WITH_PAGES

#include <string.h>

#include "engine/base/bytes.h"
#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/planelet_crc32.h"

enum {
    AT_HAS = 0,
    AT_SHIFT = 4,
    AT_PALETTE = 8,
    AT_CHECK = 12,
    AT_TEXCOORDS = PLT_TEXCOORDS_AT_BITS
};
enum { TABLES_HEAD = PLT_NORMALS_HEAD, PAGE_LEAST = PLT_PAGE_HEAD + TABLES_HEAD, KINDS = 3 };

_Static_assert((int)PLT_PAGES_HEAD == (int)PLT_TEXCOORDS_HEAD, "texture coordinates have one head");

/* ---- head -------------------------------------------------------------------------------- */

uint32_t plt_pages_head_check(const unsigned char *head, uint32_t bytes) {
    static const unsigned char none[4] = {0, 0, 0, 0};
    const uint32_t before = plt_crc32(0, head, AT_CHECK);
    return plt_crc32(plt_crc32(before, none, 4), head + AT_TEXCOORDS, bytes - AT_TEXCOORDS);
}

static int is_zero(const unsigned char *bytes, uint32_t count) {
    unsigned any = 0;
    for (uint32_t i = 0; i < count; i++) {
        any |= bytes[i];
    }
    return any == 0;
}

/* The bits of an entry of texture coordinates, which are of use without them, too: they say how
 * long pages are. */
static int set_texcoords(plt_surface_data *d, const unsigned char *head) {
#if PLT_WITH_TEXCOORDS
    const int fits = plt_texcoords_read_head(&d->texcoords, head);
    const uint32_t *bits = d->texcoords.bits;
#else
    int fits = is_zero(head + PLT_TEXCOORDS_AT_REST, PLT_PAGES_HEAD - PLT_TEXCOORDS_AT_REST);
    uint32_t bits[2];
    for (int a = 0; a < 2; a++) {
        bits[a] = plt_get_u32(head + PLT_TEXCOORDS_AT_BITS + 4 * a);
        fits &= bits[a] >= PLT_TEXCOORD_BITS_LEAST && bits[a] <= PLT_TEXCOORD_BITS_MOST;
    }
#endif
    d->pages.texcoord_bits = (uint8_t)(bits[0] + bits[1]);
    return fits;
}

/* Where the directory ends is within the section. */
static int set_pages(plt_surface_data *d, const plt_section *s, const unsigned char *head,
                     uint32_t triangles) {
    plt_surface_pages *p = &d->pages;
    const uint32_t has = plt_get_u32(head + AT_HAS), shift = plt_get_u32(head + AT_SHIFT);
    const uint32_t palette = plt_get_u32(head + AT_PALETTE);
    const uint32_t most = (has & PLT_PAGES_COLOURS) != 0 ? PLT_PALETTE_SMALL : 0;
    if (has == 0 || has > PLT_PAGES_ALL || shift < PLT_PAGE_SHIFT_LEAST ||
        shift > PLT_PAGE_SHIFT_MOST || palette > most || (palette == 0) != (most == 0) ||
        !((has & PLT_PAGES_TEXCOORDS) != 0
              ? set_texcoords(d, head)
              : is_zero(head + AT_TEXCOORDS, PLT_PAGES_HEAD - AT_TEXCOORDS))) {
        return 0;
    }
    p->at = s->offset;
    p->bytes = s->bytes;
    p->shift = (uint8_t)shift;
    p->has = (uint8_t)has;
    p->pages = (triangles >> shift) + ((triangles & ((1u << shift) - 1u)) != 0);
    p->chunks_at = PLT_PAGES_HEAD + palette * PLT_PALETTE_BYTES;
    d->palette = head + PLT_PAGES_HEAD;
    d->palette_count = palette;
    const uint32_t chunks = (p->pages + PLT_PAGES_IN_CHUNK - 1) / PLT_PAGES_IN_CHUNK;
    p->pages_at = p->chunks_at + chunks * PLT_PAGES_CHUNK;
    return p->pages_at <= s->bytes;
}

int plt_surface_pages_set(plt_surface_data *d, const plt_section *s, const unsigned char *head,
                          int is_all, uint32_t triangles, plt_fault *fault) {
    /* The head lies in the section, whose bytes are a multiple of 64; the palette may not. */
    const int fits = set_pages(d, s, head, triangles);
    if (!fits || plt_get_u32(head + AT_CHECK) != plt_pages_head_check(head, d->pages.chunks_at)) {
        return plt_refused(fault, PLT_R21_PAGES, s->offset,
                           "a section of pages does not begin as it must");
    }
    d->pages.resident = is_all ? head : NULL;
    d->is_paged = 1;
    d->has_normals = (d->pages.has & PLT_PAGES_NORMALS) != 0;
    d->has_colours = (d->pages.has & PLT_PAGES_COLOURS) != 0;
#if PLT_WITH_TEXCOORDS
    d->has_texcoords = (d->pages.has & PLT_PAGES_TEXCOORDS) != 0;
#endif
    return PLT_OK;
}

/* ---- chunks and pages -------------------------------------------------------------------- */

uint32_t plt_pages_check(uint32_t number, const unsigned char *bytes, uint32_t count) {
    unsigned char name[4];
    plt_put_u32(name, number);
    return plt_crc32(plt_crc32(0, name, sizeof name), bytes, count);
}

int plt_pages_chunk_valid(const plt_surface_pages *p, uint32_t chunk, const unsigned char *bytes) {
    int valid = plt_get_u32(bytes) == plt_pages_check(chunk, bytes + 4, PLT_PAGES_CHUNK - 4);
    const uint32_t first = chunk * PLT_PAGES_IN_CHUNK;
    uint32_t before = plt_get_u32(bytes + 4);
    valid &= before >= p->pages_at && before <= p->bytes;
    for (uint32_t i = 0; i < PLT_PAGES_IN_CHUNK; i++) {
        const uint32_t end = plt_get_u32(bytes + 8 + 4 * i);
        const int is_page = first + i < p->pages;
        valid &= end >= before && end <= p->bytes;
        valid &= is_page ? end - before >= PAGE_LEAST && end - before <= PLT_PAGE_BYTES_MOST
                         : end == before;
        before = end;
    }
    return valid;
}

/* Bits of an entry of each kind of tables. */
static uint32_t bits_of(const plt_surface_data *d, uint32_t kind) {
    return kind == 0 ? PLT_NORMAL_BITS : kind == 1 ? PLT_PAGES_COLOUR_BITS : d->pages.texcoord_bits;
}

static uint64_t tables_bytes(const unsigned char *head, uint32_t bits) {
    return TABLES_HEAD + plt_surface_tables_bytes(head, bits);
}

int plt_surface_page_valid(const plt_surface_data *d, uint32_t page, const unsigned char *bytes,
                           uint32_t count) {
    uint64_t at = PLT_PAGE_HEAD;
    for (uint32_t kind = 0; kind < KINDS; kind++) {
        if ((d->pages.has >> kind & 1u) == 0) {
            continue;
        }
        if (at + TABLES_HEAD > count) {
            return 0;
        }
        at += tables_bytes(bytes + at, bits_of(d, kind));
    }
    return at == count && plt_get_u32(bytes) ==
                              plt_pages_check(page, bytes + PLT_PAGE_HEAD, count - PLT_PAGE_HEAD);
}

static const unsigned char *set_tables(plt_surface_tables *t, const unsigned char *head,
                                       uint32_t bits) {
    plt_surface_tables_set(t, head, head + TABLES_HEAD, bits);
    return head + tables_bytes(head, bits);
}

void plt_surface_page_view(plt_surface_data *view, const plt_surface_data *d,
                           const unsigned char *bytes) {
    const unsigned char *at = bytes + PLT_PAGE_HEAD;
    memset(view, 0, sizeof *view);
    view->palette = d->palette;
    view->palette_count = d->palette_count;
#if PLT_WITH_TEXCOORDS
    view->has_texcoords = d->has_texcoords;
    view->texcoords = d->texcoords;
#endif
    view->has_normals = d->has_normals;
    view->has_colours = d->has_colours;
    if (d->has_normals) {
        at = set_tables(&view->normals, at, PLT_NORMAL_BITS);
    }
    if (d->has_colours) {
        at = set_tables(&view->colours, at, PLT_PAGES_COLOUR_BITS);
    }
#if PLT_WITH_TEXCOORDS
    if ((d->pages.has & PLT_PAGES_TEXCOORDS) != 0) {
        set_tables(&view->texcoords.tables, at, d->pages.texcoord_bits);
    }
#endif
}

static int broken(const plt_surface_pages *p, uint32_t at, const char *message, plt_fault *fault) {
    return plt_broken(fault, PLT_I31_PAGES, p->at + at, message);
}

static int validate_page(const plt_surface_data *d, uint32_t page, plt_fault *fault) {
    const plt_surface_pages *p = &d->pages;
    const uint32_t number = page / PLT_PAGES_IN_CHUNK;
    const uint32_t chunk_at = p->chunks_at + number * PLT_PAGES_CHUNK;
    const unsigned char *chunk = p->resident + chunk_at;
    if (page % PLT_PAGES_IN_CHUNK == 0 && !plt_pages_chunk_valid(p, number, chunk)) {
        return broken(p, chunk_at, PLT_PAGES_CHUNK_DAMAGED, fault);
    }
    const uint32_t at = plt_pages_offset(chunk, page), end = plt_pages_end(chunk, page);
    if (!plt_surface_page_valid(d, page, p->resident + at, end - at)) {
        return broken(p, at, PLT_PAGES_PAGE_DAMAGED, fault);
    }
    const int ends = page + 1 < p->pages || (p->bytes - end < PLT_SECTION_ALIGN &&
                                             is_zero(p->resident + end, p->bytes - end));
    return ends ? PLT_OK : broken(p, end, "a section of pages does not end with the last", fault);
}

int plt_surface_pages_validate(const plt_surface_data *d, uint32_t first, uint32_t count,
                               plt_fault *fault) {
    int status = PLT_OK;
    for (uint32_t i = 0; i < count && status == PLT_OK; i++) {
        status = validate_page(d, first + i, fault);
    }
    return status;
}

#endif
