/* further - see further.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/image/further.h"

#if PLT_WITH_FURTHER

#include <stddef.h>

#include "engine/base/bytes.h"
#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/fetch.h"
#include "engine/image/header_at.h"
#include "engine/planelet_crc32.h"

enum { TABLE_MOST = 128 };

_Static_assert(PLT_FURTHER_HEAD + PLT_FURTHER_MOST * PLT_FURTHER_ENTRY <= TABLE_MOST,
               "a table fits the stack");

static int is_zero(const unsigned char *bytes, uint32_t count) {
    unsigned any = 0;
    for (uint32_t i = 0; i < count; i++) {
        any |= bytes[i];
    }
    return any == 0;
}

int plt_further_is_full(const plt_section *s, const unsigned char *bytes, uint64_t used) {
    return used <= s->bytes && s->bytes - used < PLT_SECTION_ALIGN &&
           is_zero(bytes + used, (uint32_t)(s->bytes - used));
}

uint32_t plt_further_check(const unsigned char *table, uint32_t bytes) {
    return plt_crc32(0, table + 4, bytes - 4);
}

const plt_section *plt_further_section(const plt_header *h, uint32_t kind) {
    for (unsigned i = 0; i < PLT_FURTHER_MOST && i < h->further_count; i++) {
        if (h->further[i].kind == kind) {
            return &h->further[i];
        }
    }
    return NULL;
}

int plt_further_load(const plt_source *source, const plt_section *s, unsigned char *room,
                     const unsigned char **bytes, plt_fault *fault) {
    const unsigned char *mapped = source->mapped;
    *bytes = mapped != NULL ? mapped + s->offset : room;
    if (mapped == NULL) {
        const int status = plt_fetch(source, s->offset, room, s->bytes, fault);
        if (status != PLT_OK) {
            return status;
        }
    }
    return plt_crc32(0, *bytes, s->bytes) == s->crc
               ? PLT_OK
               : plt_refused(fault, PLT_R13_SECTION_CRC, s->offset,
                             "a section is damaged (checksum)");
}

static int refused(plt_fault *fault, uint32_t offset) {
    return plt_refused(fault, PLT_R17_FURTHER, offset,
                       "the table of further sections is not what it must be");
}

/* Kinds rise, so that each is there once; this engine knows all of them, also those that it has no
 * use for. */
static int is_known(uint32_t kind, uint32_t before) {
    return kind > before && kind >= PLT_SECTION_NORMALS && kind <= PLT_SECTION_PAGES;
}

/* They name triangles by their primitive ids, or none. */
static int is_of_materials(uint32_t kind) {
    return kind == PLT_SECTION_MATERIALS || kind == PLT_SECTION_TEXTURES ||
           kind == PLT_SECTION_TILES;
}

/* What corners have is of triangles that stay where they are, and none is of bodies, whose
 * triangles have numbers of their own. */
static int is_allowed(const plt_info *info, uint32_t kind) {
    return info->instances == 0 && (info->frames == 0 || is_of_materials(kind));
}

static void put_bytes(plt_info *info, const plt_section *s) {
#if PLT_WITH_SURFACE
    if (s->kind == PLT_SECTION_NORMALS) {
        info->normal_bytes = s->bytes;
    } else if (s->kind == PLT_SECTION_COLOURS) {
        info->colour_bytes = s->bytes;
    }
#endif
#if PLT_WITH_PAGES
    if (s->kind == PLT_SECTION_PAGES) {
        info->page_bytes = s->bytes;
    }
#endif
#if PLT_WITH_TEXCOORDS
    if (s->kind == PLT_SECTION_TEXCOORDS) {
        info->texcoord_bytes = s->bytes;
    }
#endif
#if PLT_WITH_MATERIALS
    if (s->kind == PLT_SECTION_MATERIALS) {
        info->material_bytes = s->bytes;
    }
#endif
#if PLT_WITH_TEXTURE
    if (s->kind == PLT_SECTION_TEXTURES) {
        info->texture_bytes = s->bytes;
    } else if (s->kind == PLT_SECTION_TILES) {
        info->tile_bytes = s->bytes;
    }
#endif
}

static int read_entries(plt_header *h, const unsigned char *table, uint32_t bytes,
                        plt_fault *fault) {
    uint64_t offset = (uint64_t)h->further_at + bytes;
    uint32_t before = 0;
    for (uint32_t i = 0; i < h->further_count; i++) {
        const uint32_t at = PLT_FURTHER_HEAD + i * PLT_FURTHER_ENTRY;
        const plt_section s = {plt_get_u32(table + at), plt_get_u32(table + at + 4),
                               plt_get_u32(table + at + 8), plt_get_u32(table + at + 12)};
        if (!is_known(s.kind, before) || s.offset != offset || s.bytes == 0 ||
            s.bytes % PLT_SECTION_ALIGN != 0) {
            return refused(fault, h->further_at + at);
        }
        if (!is_allowed(&h->info, s.kind)) {
            return plt_refused(fault, PLT_R17_FURTHER, h->further_at + at,
                               "an image with frames or instances has a section that it must not");
        }
        h->further[i] = s;
        put_bytes(&h->info, &s);
        before = s.kind;
        offset += s.bytes;
    }
    return offset == h->info.image_bytes ? PLT_OK : refused(fault, PLT_AT_IMAGE_BYTES);
}

int plt_further_read(const plt_source *source, plt_header *h, plt_fault *fault) {
    unsigned char table[TABLE_MOST];
    if (h->further_count == 0) {
        return PLT_OK;
    }
    if (h->further_count > PLT_FURTHER_MOST) {
        return refused(fault, PLT_AT_FURTHER);
    }
    const uint32_t bytes = plt_further_table_bytes(h->further_count);
    const uint32_t used = PLT_FURTHER_HEAD + h->further_count * PLT_FURTHER_ENTRY;
    if ((uint64_t)h->further_at + bytes > h->info.image_bytes) {
        return refused(fault, PLT_AT_IMAGE_BYTES);
    }
    const int status = plt_fetch(source, h->further_at, table, bytes, fault);
    if (status != PLT_OK) {
        return status;
    }
    if (plt_get_u32(table) != plt_further_check(table, bytes) || !is_zero(table + 4, 12) ||
        !is_zero(table + used, bytes - used)) {
        return refused(fault, h->further_at);
    }
    return read_entries(h, table, bytes, fault);
}

#endif
