/* directory - which textures an image has, and which materials have them: SPEC.md, 4.22
 *
 * Invariant: plt_directory_read has been through what is read here, so that a texture has 1 .. 15
 * levels of at least one texel, all of whose tiles are there.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TEXTURE_DIRECTORY_H
#define PLT_TEXTURE_DIRECTORY_H

#include "engine/base/bytes.h"
#include "engine/planelet.h"

enum plt_texture_format {
    PLT_TEXTURE_RGB565 = 0, /* tiles of 8 x 8 texels, 2 bytes each */
    PLT_TEXTURE_BLOCKS = 1  /* tiles of 16 x 16 texels, in blocks of 4 x 4, 8 bytes each */
};

enum {
    PLT_TEXTURES_MOST = 255,
    PLT_TEXTURE_SIDE_MOST = 16384,
    PLT_DIRECTORY_HEAD = 16,
    PLT_TEXTURE_ENTRY = 12, /* of a texture */
    PLT_PAINT_ENTRY = 20,   /* of a material */
    PLT_PAINTS_MOST = 256
};
#define PLT_PAINT_MOST 65536.0f /* of its scale and offset */

typedef struct plt_texture {
    uint32_t width, height; /* texels, 1 .. PLT_TEXTURE_SIDE_MOST */
    uint32_t first;         /* of its tiles, those of level 0 first */
    uint8_t levels, format; /* enum plt_texture_format */
} plt_texture;

/* How a material has its texture: at scale * texcoord + offset. */
typedef struct plt_paint {
    float scale[2], offset[2]; /* within +-PLT_PAINT_MOST */
    uint8_t texture;           /* 1 + its number; 0: none */
    uint8_t clamp;             /* 1: beyond its borders they go on; 0: it repeats */
} plt_paint;

typedef struct plt_directory {
    const unsigned char *texture, *paint; /* entries */
    uint32_t textures, paints, tiles;
} plt_directory;

/* Bytes of a section, padding included. */
static inline uint32_t plt_directory_bytes(uint32_t textures, uint32_t paints) {
    return (PLT_DIRECTORY_HEAD + textures * PLT_TEXTURE_ENTRY + paints * PLT_PAINT_ENTRY + 63u) &
           ~63u;
}

/* The side of a level above one of `side`. */
static inline uint32_t plt_texture_halved(uint32_t side) {
    return side > 1 ? side / 2 : 1;
}

/* Texels along a tile's side, as a power of two. */
static inline unsigned plt_texture_tile_shift(uint8_t format) {
    return format == PLT_TEXTURE_BLOCKS ? 4 : 3;
}

/* Tiles of a level. */
static inline uint32_t plt_texture_tiles_along(uint32_t side, unsigned shift) {
    return (side + (1u << shift) - 1) >> shift;
}

#if PLT_WITH_TEXTURE
/* Levels down to one texel. */
unsigned plt_texture_levels(uint32_t width, uint32_t height);
/* Tiles of all levels: below 2^24. */
uint32_t plt_texture_tiles(const plt_texture *texture);

/* That of a section. PLT_ERR_IMAGE: it breaks R20; `offset` is where the section begins,
 * `tile_bytes` is how long that of the tiles is. */
int plt_directory_read(plt_directory *directory, const unsigned char *section, uint32_t bytes,
                       uint32_t tile_bytes, uint32_t offset, plt_fault *fault);

void plt_directory_texture(const plt_directory *directory, uint32_t number, plt_texture *to);
/* Of a material that is not there: no texture. */
void plt_directory_paint(const plt_directory *directory, uint32_t material, plt_paint *to);
#endif

#endif
