/* tiles - see tiles.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/texture/tiles.h"

#if PLT_WITH_TEXTURE

#include <stddef.h>

#include "engine/base/bytes.h"
#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/fetch.h"
#include "engine/planelet_crc32.h"

enum { WAYS = 4 };

uint32_t plt_tile_check(uint32_t number, const unsigned char *texels) {
    unsigned char key[4];
    plt_put_u32(key, number);
    return plt_crc32(plt_crc32(0, key, sizeof key), texels, PLT_TEXELS_BYTES);
}

void plt_tiles_init(plt_tiles *t, const plt_source *source, uint32_t at, void *room,
                    uint32_t bytes) {
    const uint32_t slots = bytes / (uint32_t)sizeof(plt_tile_slot);
    const plt_texture_stats none = {0};
    t->source = source;
    t->at = at;
    t->mapped = source->mapped != NULL ? (const unsigned char *)source->mapped + at : NULL;
    t->slot = room;
    t->ways = slots < WAYS ? slots : WAYS;
    t->sets = slots < WAYS ? 1 : slots / WAYS;
    t->time = 0;
    t->last = PLT_TILE_NONE;
    t->stats = none;
    t->failed = 0;
    for (uint32_t i = 0; t->mapped == NULL && i < t->sets * t->ways; i++) {
        t->slot[i].number = PLT_TILE_NONE;
        t->slot[i].used = 0;
    }
}

static int fetch_once(plt_tiles *t, uint32_t number, plt_tile_slot *slot) {
    const uint32_t at = t->at + number * PLT_TILE_BYTES;
    const int status = plt_fetch(t->source, at, slot->bytes, PLT_TILE_BYTES, &t->fault);
    t->stats.bytes_fetched += PLT_TILE_BYTES;
    if (status == PLT_OK &&
        plt_get_u32(slot->bytes + PLT_TEXELS_BYTES) != plt_tile_check(number, slot->bytes)) {
        return plt_broken(&t->fault, PLT_I30_TILES, at, "a tile of a texture is damaged");
    }
    return status;
}

static int fetch(plt_tiles *t, uint32_t number, plt_tile_slot *slot) {
    int status = PLT_ERR_SOURCE;
    slot->number = PLT_TILE_NONE;
    t->stats.fetched++;
    for (unsigned tries = 0; tries < PLT_FETCH_TRIES && status != PLT_OK; tries++) {
        status = fetch_once(t, number, slot);
        t->stats.retries += tries > 0;
    }
    slot->number = status == PLT_OK ? number : PLT_TILE_NONE;
    return status;
}

/* The slot of a tile, or else of its set the one that was used longest ago. */
static plt_tile_slot *slot_of(plt_tiles *t, uint32_t number) {
    const uint32_t set = (uint32_t)((uint64_t)(number * 0x9E3779B1u) * t->sets >> 32);
    plt_tile_slot *slot = &t->slot[set * t->ways], *oldest = slot;
    for (uint32_t i = 0; i < t->ways; i++) {
        if (slot[i].number == number) {
            return &slot[i];
        }
        oldest = t->time - slot[i].used > t->time - oldest->used ? &slot[i] : oldest;
    }
    return oldest;
}

int plt_tiles_get(plt_tiles *t, uint32_t number, const unsigned char **texels) {
    if (number == t->last) {
        *texels = t->last_bytes;
        return PLT_OK;
    }
    if (t->mapped != NULL) {
        t->last_bytes = t->mapped + number * (size_t)PLT_TILE_BYTES;
    } else {
        plt_tile_slot *slot = slot_of(t, number);
        t->last = PLT_TILE_NONE; /* its slot may be taken, and then not be filled */
        if (slot->number != number) {
            const int status = fetch(t, number, slot);
            if (status != PLT_OK) {
                t->failed = 1;
                return status;
            }
        } else {
            t->stats.found++;
        }
        slot->used = ++t->time;
        t->last_bytes = slot->bytes;
    }
    t->last = number;
    *texels = t->last_bytes;
    return PLT_OK;
}

#endif
