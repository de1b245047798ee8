/* texture_list - see texture_list.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/texture_list.h"

#include <inttypes.h>
#include <stdio.h>

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/fetch.h"
#include "engine/image/further.h"
#include "engine/planelet_crc32.h"
#include "engine/texture/tiles.h"
#include "host_tools/base/heap.h"

static const char *const formats[] = {"rgb565", "blocks"};

static int read_header(const plt_source *source, plt_header *h, plt_fault *fault) {
    unsigned char bytes[PLT_HEADER_BYTES];
    int status = plt_fetch(source, 0, bytes, sizeof bytes, fault);
    status = status == PLT_OK ? plt_header_read(h, bytes, source->bytes, fault) : status;
    return status == PLT_OK ? plt_further_read(source, h, fault) : status;
}

static int read_section(texture_list *l, const plt_source *source, const plt_section *s,
                        uint32_t tile_bytes, plt_fault *fault) {
    l->section = heap_get(s->bytes);
    if (l->section == NULL) {
        return plt_fault_set(fault, PLT_ERR_SOURCE, s->offset, "out of memory");
    }
    const int status = plt_fetch(source, s->offset, l->section, s->bytes, fault);
    if (status == PLT_OK && plt_crc32(0, l->section, s->bytes) != s->crc) {
        return plt_refused(fault, PLT_R13_SECTION_CRC, s->offset,
                           "a section is damaged (checksum)");
    }
    return status != PLT_OK ? status
                            : plt_directory_read(&l->directory, l->section, s->bytes, tile_bytes,
                                                 s->offset, fault);
}

int texture_list_read(texture_list *l, const plt_source *source, plt_fault *fault) {
    plt_header h;
    *l = (texture_list){.section = NULL};
    int status = read_header(source, &h, fault);
    const plt_section *s = status == PLT_OK ? plt_further_section(&h, PLT_SECTION_TEXTURES) : NULL;
    if (s == NULL) {
        return status;
    }
    status = read_section(l, source, s, h.info.tile_bytes, fault);
    l->bytes = (uint64_t)s->bytes + h.info.tile_bytes;
    for (uint32_t i = 0; i < l->directory.textures && status == PLT_OK; i++) {
        plt_texture t;
        plt_directory_texture(&l->directory, i, &t);
        l->texels += (uint64_t)t.width * t.height;
    }
    if (status != PLT_OK) {
        texture_list_free(l);
    }
    return status;
}

static uint32_t bytes_of(const plt_texture *t) {
    return plt_texture_tiles(t) * PLT_TILE_BYTES;
}

void texture_list_print(const texture_list *l) {
    if (l->section == NULL) {
        return;
    }
    printf("texture bytes      %" PRIu64 ", %.2f per texel\n", l->bytes,
           (double)l->bytes / (double)l->texels);
    for (uint32_t i = 0; i < l->directory.textures; i++) {
        plt_texture t;
        plt_directory_texture(&l->directory, i, &t);
        printf("  %-16" PRIu32 " %u x %u texels, %u levels, %s, %u bytes\n", i, t.width, t.height,
               t.levels, formats[t.format], bytes_of(&t));
    }
}

void texture_list_print_json(const texture_list *l) {
    printf("  \"texture_bytes\": %" PRIu64 ",\n  \"textures\": [", l->bytes);
    for (uint32_t i = 0; l->section != NULL && i < l->directory.textures; i++) {
        plt_texture t;
        plt_directory_texture(&l->directory, i, &t);
        printf(
            "%s\n    {\"width\": %u, \"height\": %u, \"levels\": %u, \"format\": \"%s\", "
            "\"bytes\": %u}",
            i > 0 ? "," : "", t.width, t.height, t.levels, formats[t.format], bytes_of(&t));
    }
    printf("],\n");
}

void texture_list_free(texture_list *l) {
    heap_drop(l->section);
    *l = (texture_list){.section = NULL};
}
