/* directory - see directory.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/texture/directory.h"

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/texture/tiles.h"

#if PLT_WITH_TEXTURE

enum { AT_TEXTURES = 0, AT_PAINTS = 4, AT_TILES = 8, AT_RESERVED = 12 };

unsigned plt_texture_levels(uint32_t width, uint32_t height) {
    unsigned levels = 1;
    for (uint32_t most = width > height ? width : height; most > 1; most /= 2) {
        levels++;
    }
    return levels;
}

uint32_t plt_texture_tiles(const plt_texture *t) {
    const unsigned shift = plt_texture_tile_shift(t->format);
    uint32_t width = t->width, height = t->height, tiles = 0;
    for (unsigned i = 0; i < t->levels; i++) {
        tiles += plt_texture_tiles_along(width, shift) * plt_texture_tiles_along(height, shift);
        width = plt_texture_halved(width);
        height = plt_texture_halved(height);
    }
    return tiles;
}

static uint32_t get_u16(const unsigned char *at) {
    return at[0] | (uint32_t)at[1] << 8;
}

void plt_directory_texture(const plt_directory *d, uint32_t number, plt_texture *t) {
    const unsigned char *at = d->texture + number * PLT_TEXTURE_ENTRY;
    t->width = get_u16(at);
    t->height = get_u16(at + 2);
    t->levels = at[4];
    t->format = at[5];
    t->first = plt_get_u32(at + 8);
}

void plt_directory_paint(const plt_directory *d, uint32_t material, plt_paint *p) {
    const unsigned char *at = d->paint + material * PLT_PAINT_ENTRY;
    if (material >= d->paints) {
        p->texture = 0;
        return;
    }
    p->texture = at[0];
    p->clamp = at[1];
    plt_get_floats(p->scale, at + 4, 2);
    plt_get_floats(p->offset, at + 12, 2);
}

static int is_side(uint32_t side) {
    return side >= 1 && side <= PLT_TEXTURE_SIDE_MOST;
}

/* `tiles` are those of the textures before it. */
static int is_texture(const plt_directory *d, uint32_t number, uint64_t tiles, plt_texture *t) {
    const unsigned char *at = d->texture + number * PLT_TEXTURE_ENTRY;
    plt_directory_texture(d, number, t);
    return is_side(t->width) && is_side(t->height) && t->levels >= 1 &&
           t->levels <= plt_texture_levels(t->width, t->height) &&
           t->format <= PLT_TEXTURE_BLOCKS && get_u16(at + 6) == 0 && t->first == tiles;
}

static int is_paint(const plt_directory *d, uint32_t number) {
    const unsigned char *at = d->paint + number * PLT_PAINT_ENTRY;
    int good = at[0] <= d->textures && at[1] <= 1 && get_u16(at + 2) == 0;
    for (unsigned i = 0; i < 4; i++) {
        const float x = plt_get_float(at + 4 + 4 * i);
        good &= x >= -PLT_PAINT_MOST && x <= PLT_PAINT_MOST; /* false for NaN */
    }
    return good;
}

static int refused(plt_fault *fault, uint32_t offset, const char *message) {
    return plt_refused(fault, PLT_R20_TEXTURES, offset, message);
}

static int check_textures(const plt_directory *d, uint32_t tile_bytes, uint32_t offset,
                          plt_fault *fault) {
    uint64_t tiles = 0;
    for (uint32_t i = 0; i < d->textures; i++) {
        plt_texture t;
        if (!is_texture(d, i, tiles, &t)) {
            return refused(fault, offset + PLT_DIRECTORY_HEAD + i * PLT_TEXTURE_ENTRY,
                           "a texture's size, levels or tiles are not as they must be");
        }
        tiles += plt_texture_tiles(&t);
    }
    return tiles == d->tiles && plt_tiles_bytes(tiles) == tile_bytes
               ? PLT_OK
               : refused(fault, offset, "the tiles of textures are more or fewer than those");
}

int plt_directory_read(plt_directory *d, const unsigned char *section, uint32_t bytes,
                       uint32_t tile_bytes, uint32_t offset, plt_fault *fault) {
    d->textures = plt_get_u32(section + AT_TEXTURES);
    d->paints = plt_get_u32(section + AT_PAINTS);
    d->tiles = plt_get_u32(section + AT_TILES);
    if (d->textures < 1 || d->textures > PLT_TEXTURES_MOST || d->paints < 1 ||
        d->paints > PLT_PAINTS_MOST || plt_get_u32(section + AT_RESERVED) != 0 ||
        plt_directory_bytes(d->textures, d->paints) != bytes) {
        return refused(fault, offset, "a count of the textures is out of range");
    }
    d->texture = section + PLT_DIRECTORY_HEAD;
    d->paint = d->texture + d->textures * PLT_TEXTURE_ENTRY;
    for (uint32_t i = 0; i < d->paints; i++) {
        if (!is_paint(d, i)) {
            return refused(fault, (uint32_t)(offset + (d->paint - section) + i * PLT_PAINT_ENTRY),
                           "a material's texture is not there, or a number of it out of range");
        }
    }
    return check_textures(d, tile_bytes, offset, fault);
}

#endif
