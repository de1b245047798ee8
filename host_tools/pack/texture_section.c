/* texture_section - see texture_section.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/texture_section.h"

#include <math.h>
#include <string.h>

#include "engine/base/bytes.h"
#include "engine/image/header.h"
#include "engine/texture/directory.h"
#include "engine/texture/texel.h"
#include "engine/texture/tiles.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/further_add.h"
#include "host_tools/pack/image_size.h"
#include "host_tools/pack/texture_code.h"
#include "host_tools/pack/texture_levels.h"

#define PSNR_MOST 99.0

typedef struct job {
    const texture_set *set;
    unsigned char *tiles; /* the section */
    uint32_t tile;        /* the next */
    double squares;       /* that texels of level 0 are off */
} job;

static plt_texture texture_of(const texture_set *set, uint32_t number, uint32_t first) {
    const picture *p = &set->picture[number];
    return (plt_texture){.width = p->width,
                         .height = p->height,
                         .first = first,
                         .levels = (uint8_t)plt_texture_levels(p->width, p->height),
                         .format = set->format};
}

static uint32_t all_tiles(const texture_set *set) {
    uint32_t tiles = 0;
    for (uint32_t i = 0; i < set->pictures; i++) {
        const plt_texture t = texture_of(set, i, 0);
        tiles += plt_texture_tiles(&t);
    }
    return tiles;
}

static void put_u16(unsigned char *to, uint32_t value) {
    to[0] = (unsigned char)(value & 255u);
    to[1] = (unsigned char)(value >> 8);
}

/* `to` is zero. */
static void put_directory(const texture_set *set, uint32_t tiles, unsigned char *to) {
    uint32_t first = 0;
    plt_put_u32(to, set->pictures);
    plt_put_u32(to + 4, set->paints);
    plt_put_u32(to + 8, tiles);
    to += PLT_DIRECTORY_HEAD;
    for (uint32_t i = 0; i < set->pictures; i++, to += PLT_TEXTURE_ENTRY) {
        const plt_texture t = texture_of(set, i, first);
        put_u16(to, t.width);
        put_u16(to + 2, t.height);
        to[4] = t.levels;
        to[5] = t.format;
        plt_put_u32(to + 8, first);
        first += plt_texture_tiles(&t);
    }
    for (uint32_t i = 0; i < set->paints; i++, to += PLT_PAINT_ENTRY) {
        to[0] = (unsigned char)set->paint[i].texture;
        to[1] = (unsigned char)(set->paint[i].clamp != 0);
        plt_put_floats(to + 4, set->paint[i].scale, 2);
        plt_put_floats(to + 12, set->paint[i].offset, 2);
    }
}

static void put_rgb565(const texture_level *l, uint32_t x, uint32_t y, unsigned char *to) {
    for (uint32_t i = 0; i < 64; i++) {
        uint8_t rgb[3];
        texture_level_bytes(l, x + i % 8, y + i / 8, rgb);
        put_u16(to + 2 * i, texture_rgb565(rgb));
    }
}

static void put_blocks(const texture_level *l, uint32_t x, uint32_t y, unsigned char *to) {
    for (uint32_t b = 0; b < 16; b++, to += PLT_BLOCK_BYTES) {
        uint8_t texel[16][3];
        for (uint32_t i = 0; i < 16; i++) {
            texture_level_bytes(l, x + 4 * (b % 4) + i % 4, y + 4 * (b / 4) + i / 4, texel[i]);
        }
        texture_block((const uint8_t(*)[3])texel, to);
    }
}

/* How far the texels of a tile that lie in the level are off. */
static double squares_of(const texture_level *l, uint8_t format, uint32_t x, uint32_t y,
                         const unsigned char *tile) {
    const uint32_t side = 1u << plt_texture_tile_shift(format);
    double sum = 0.0;
    for (uint32_t i = 0; i < side * side; i++) {
        const uint32_t column = i % side, row = i / side;
        uint8_t is[3], was[3];
        if (format == PLT_TEXTURE_BLOCKS) {
            plt_texel_block(tile, column, row, is);
        } else {
            plt_texel_rgb565(tile, column, row, is);
        }
        texture_level_bytes(l, x + column, y + row, was);
        for (int c = 0; c < 3 && x + column < l->width && y + row < l->height; c++) {
            sum += (double)(is[c] - was[c]) * (is[c] - was[c]);
        }
    }
    return sum;
}

static void put_level(job *j, const texture_level *l, int is_first) {
    const uint8_t format = j->set->format;
    const uint32_t side = 1u << plt_texture_tile_shift(format);
    for (uint32_t y = 0; y < l->height; y += side) {
        for (uint32_t x = 0; x < l->width; x += side, j->tile++) {
            unsigned char *to = j->tiles + (uint64_t)j->tile * PLT_TILE_BYTES;
            if (format == PLT_TEXTURE_BLOCKS) {
                put_blocks(l, x, y, to);
            } else {
                put_rgb565(l, x, y, to);
            }
            plt_put_u32(to + PLT_TEXELS_BYTES, plt_tile_check(j->tile, to));
            j->squares += is_first ? squares_of(l, format, x, y, to) : 0.0;
        }
    }
}

/* -1: memory is out. */
static int put_picture(job *j, const picture *p) {
    texture_level l = {0, 0, NULL}, next = {0, 0, NULL};
    int status = texture_level_first(&l, p);
    const unsigned levels = plt_texture_levels(p->width, p->height);
    for (unsigned i = 0; i < levels && status == 0; i++) {
        put_level(j, &l, i == 0);
        if (i + 1 < levels) {
            status = texture_level_next(&next, &l);
            texture_level_free(&l);
            l = next;
        }
    }
    texture_level_free(&l);
    return status;
}

static int fail_memory(const char *name, fail *f) {
    return fail_set(f, name, "out of memory; use a larger machine");
}

static int put_all(packed *image, job *j, uint32_t tiles, const char *name, fail *f) {
    const uint32_t bytes = plt_directory_bytes(j->set->pictures, j->set->paints);
    const uint64_t size = plt_tiles_bytes(tiles);
    unsigned char *directory = heap_get_zeroed(bytes);
    int status = directory != NULL ? 0 : fail_memory(name, f);
    j->tiles = heap_get_zeroed(size);
    if (j->tiles == NULL) {
        status = fail_memory(name, f);
    }
    for (uint32_t i = 0; i < j->set->pictures && status == 0; i++) {
        status = put_picture(j, &j->set->picture[i]) == 0 ? 0 : fail_memory(name, f);
    }
    if (status == 0) {
        put_directory(j->set, tiles, directory);
        status = further_add(image, PLT_SECTION_TEXTURES, directory, bytes, name, f);
    }
    if (status == 0) {
        status = further_add(image, PLT_SECTION_TILES, j->tiles, (uint32_t)size, name, f);
    }
    heap_drop(directory);
    heap_drop(j->tiles);
    return status;
}

int texture_section_add(packed *image, const texture_set *set, const char *name,
                        texture_stats *stats, fail *f) {
    job j = {.set = set};
    const uint32_t tiles = all_tiles(set);
    const uint64_t size = plt_tiles_bytes(tiles) + plt_directory_bytes(set->pictures, set->paints);
    const char *remedy = "use --textures blocks, or none";
    if (image_size_check(name, image->info.triangles, image->size + size + 2 * FURTHER_ADD_MORE, 0,
                         remedy, f) != 0 ||
        put_all(image, &j, tiles, name, f) != 0) {
        return -1;
    }
    *stats = (texture_stats){.textures = set->pictures, .bytes = (uint32_t)size};
    for (uint32_t i = 0; i < set->pictures; i++) {
        stats->texels += (uint64_t)set->picture[i].width * set->picture[i].height;
    }
    const double mean = j.squares / (3.0 * (double)stats->texels);
    stats->psnr = mean > 0.0 ? 10.0 * log10(255.0 * 255.0 / mean) : PSNR_MOST;
    return 0;
}
