/* texture_room - see texture_room.h; and what is counted of tiles
 *
 * SPDX-License-Identifier: MIT */
#include "engine/texture_room.h"

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/fetch.h"
#include "engine/image/further.h"
#include "engine/materials_room.h"
#include "engine/planelet_crc32.h"
#include "engine/scene/formats.h"

#if PLT_WITH_TEXTURE

_Static_assert(PLT_TEXTURE_LEAST == sizeof(plt_tile_slot), "as planelet.h says");

static int check_crc(const plt_section *s, const unsigned char *bytes, plt_fault *fault) {
    return plt_crc32(0, bytes, s->bytes) == s->crc
               ? PLT_OK
               : plt_refused(fault, PLT_R13_SECTION_CRC, s->offset,
                             "a section is damaged (checksum)");
}

/* Tiles that are fetched have checks of their own. */
static int read_directory(const plt_engine *e, plt_directory *d, const plt_section *textures,
                          const plt_section *tiles, unsigned char *room, plt_fault *fault) {
    const unsigned char *mapped = e->source.mapped;
    int status = PLT_OK;
    if (mapped == NULL) {
        status = plt_fetch(&e->source, textures->offset, room, textures->bytes, fault);
    } else if (tiles != NULL) {
        status = check_crc(tiles, mapped + tiles->offset, fault);
    }
    const unsigned char *bytes = mapped != NULL ? mapped + textures->offset : room;
    status = status == PLT_OK ? check_crc(textures, bytes, fault) : status;
    return status != PLT_OK
               ? status
               : plt_directory_read(d, bytes, textures->bytes, tiles != NULL ? tiles->bytes : 0,
                                    textures->offset, fault);
}

/* Those of lights, if there is room for these, or else for textures alone. */
static int read_materials(plt_engine *e, const plt_header *h, void *const part[PLT_PARTS_COUNT],
                          plt_fault *fault) {
    plt_materials *to = &e->rendering.paint.materials;
#if PLT_WITH_WHITTED
    if (e->rendering.whitted != NULL) {
        *to = e->rendering.whitted->materials;
        return PLT_OK;
    }
#endif
    return plt_materials_room_set(e, h, part, to, fault);
}

static void set_textures(plt_engine *e, plt_textures *t) {
    e->rendering.paint.textures = t;
#if PLT_WITH_WHITTED
    if (e->rendering.whitted != NULL) {
        e->rendering.whitted->textures = t;
    }
#endif
}

int plt_texture_room_set(plt_engine *e, const plt_header *h, void *const part[PLT_PARTS_COUNT],
                         plt_fault *fault) {
    plt_textures *t = part[PLT_PART_TEXTURES];
    if (!plt_texture_room_is_wanted(&e->scene.info, &e->options,
                                    (enum plt_format)e->scene.format)) {
        return PLT_OK; /* and there may be no header */
    }
    const plt_section *textures = plt_further_section(h, PLT_SECTION_TEXTURES);
    const plt_section *tiles = plt_further_section(h, PLT_SECTION_TILES);
    unsigned char *room = (unsigned char *)t + PLT_TEXTURE_STATE_BYTES;
    int status = read_directory(e, &t->directory, textures, tiles, room, fault);
    if (status == PLT_OK) {
        status = read_materials(e, h, part, fault);
    }
    if (status == PLT_OK) {
        t->filter = e->options.textures;
        plt_tiles_init(&t->tiles, &e->source, tiles->offset, part[PLT_PART_TILES],
                       plt_texture_tiles_bytes(&e->options));
        set_textures(e, t);
    }
    return status;
}

void plt_texture_stats_get(const plt_engine *e, plt_texture_stats *stats) {
    const plt_texture_stats none = {0};
    const plt_textures *t = e->rendering.paint.textures;
    *stats = t != NULL ? t->tiles.stats : none;
}

void plt_texture_stats_reset(plt_engine *e) {
    const plt_texture_stats none = {0};
    plt_textures *t = e->rendering.paint.textures;
    if (t != NULL) {
        t->tiles.stats = none;
    }
}

void plt_texture_forget(plt_engine *e) {
    plt_textures *t = e->rendering.paint.textures;
    if (t != NULL) {
        t->tiles.failed = 0;
    }
}

int plt_texture_failed(const plt_engine *e, plt_fault *fault) {
    const plt_textures *t = e->rendering.paint.textures;
    if (t == NULL || !t->tiles.failed) {
        return 0;
    }
    *fault = t->tiles.fault;
    return 1;
}

#endif
