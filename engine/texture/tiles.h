/* tiles - squares of texels: where the image is mapped, or in a room that they are fetched to
 *
 * A tile is 128 bytes and their check. The room has slots in sets of four; of a set the one that
 * was used longest ago is given up. What is fetched is checked, and fetched again if it is wrong,
 * as parts of streamed scenes are (memory/fetcher.h); it is waited for.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TEXTURE_TILES_H
#define PLT_TEXTURE_TILES_H

#include "engine/planelet.h"

enum { PLT_TEXELS_BYTES = 128, PLT_TILE_BYTES = PLT_TEXELS_BYTES + 4 };
#define PLT_TILE_NONE 0xFFFFFFFFu

/* Bytes of a section of so many tiles, padding included. */
static inline uint64_t plt_tiles_bytes(uint64_t tiles) {
    return (tiles * PLT_TILE_BYTES + 63) & ~63ull;
}

#if PLT_WITH_TEXTURE

typedef struct plt_tile_slot {
    uint32_t number; /* of the tile; PLT_TILE_NONE: it has none */
    uint32_t used;   /* when it was found last */
    unsigned char bytes[PLT_TILE_BYTES];
} plt_tile_slot;

typedef struct plt_tiles {
    const unsigned char *mapped; /* the section; NULL: tiles are fetched */
    const plt_source *source;
    uint32_t at; /* where the section begins in the image */
    plt_tile_slot *slot;
    uint32_t sets, ways, time;
    uint32_t last; /* tile that was asked for last, and where it is */
    const unsigned char *last_bytes;
    plt_texture_stats stats;
    plt_fault fault; /* why a call failed, if `failed` */
    uint8_t failed;  /* until it is cleared */
} plt_tiles;

/* The check of a tile, of its number and 128 bytes. */
uint32_t plt_tile_check(uint32_t number, const unsigned char *texels);

/* Of a section that begins at `at`. Fetched tiles go to `room`, `bytes` of it, aligned to 4: as
 * many as fit, at least one. */
void plt_tiles_init(plt_tiles *tiles, const plt_source *source, uint32_t at, void *room,
                    uint32_t bytes);

/* Points *texels at a tile that is there, until the next call. PLT_OK, PLT_ERR_SOURCE, or
 * PLT_ERR_IMAGE: its check is wrong (I30). */
int plt_tiles_get(plt_tiles *tiles, uint32_t number, const unsigned char **texels);

#endif
#endif
