/* texture_rig - textures of random pictures, in an image, and what SPEC.md says of their texels
 *
 * The reference reads the sections' bytes by itself, in double precision.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_TEXTURE_RIG_H
#define REFERENCE_TEXTURE_RIG_H

#include "engine/texture/sample.h"
#include "host_tools/pack/texture_section.h"
#include "tests/reference/lit_rig.h"
#include "tests/reference/random.h"

enum { TEXTURE_PICTURES = 6 };

typedef struct texture_scene {
    lit_scene lit;
    picture picture[TEXTURE_PICTURES]; /* of sides 1 to 70, some smooth, some noise */
    texture_paint paint[LIT_MATERIALS + 1];
    packed image; /* with materials, textures and coordinates */
    texture_stats stats;
    uint32_t at, bytes;            /* the section of textures */
    uint32_t tiles_at, tile_bytes; /* ... and of tiles */
} texture_scene;

/* All of one format. Materials 0 to 5 have pictures 0 to 5, with clamp, scale and offset of some.
 * An image of that kind, or a list of triangles; coordinates in pages of 2^shift triangles, or in a
 * table. */
enum { TEXTURE_TABLE = 0, TEXTURE_PAGES = 6 };
void texture_scene_make_as(texture_scene *s, uint8_t format, uint32_t seed, enum lit_image kind,
                           uint32_t shift);
void texture_scene_make(texture_scene *s, uint8_t format, uint32_t seed);
void texture_scene_free(texture_scene *s);

/* A bit of each tile is another; once more, and they are whole again. */
void texture_scene_flip_tiles(const texture_scene *s);

/* A directory and tiles over the image, `room` bytes of slots or, if NULL, mapped. 0, or -1. */
int texture_scene_open(const texture_scene *s, plt_textures *t, plt_source *source, void *room,
                       uint32_t room_bytes);

/* Sides of a level, its first tile, and the sRGB bytes of a texel of it, as the section has it. */
typedef struct texture_reference {
    uint32_t width, height, first;
    uint8_t format;
    const unsigned char *tiles;
} texture_reference;

texture_reference texture_reference_level(const texture_scene *s, uint32_t number, unsigned level);
void texture_reference_texel(const texture_reference *r, uint32_t x, uint32_t y, double rgb[3]);

/* Linear light of a byte, 0 .. 1. */
double texture_reference_light(double byte);

#endif
