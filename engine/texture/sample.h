/* sample - the light that a texture lets a surface reflect at a point
 *
 * Integers from the texels on: the same bits on every machine.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TEXTURE_SAMPLE_H
#define PLT_TEXTURE_SAMPLE_H

#include "engine/texture/directory.h"
#include "engine/texture/tiles.h"

#if PLT_WITH_TEXTURE

typedef struct plt_textures {
    plt_directory directory; /* textures 0: there are none */
    plt_tiles tiles;
    uint8_t filter; /* enum plt_texture_filter */
} plt_textures;

/* Of a material's texture at texture coordinates (u right, v up; any floats), red, green and blue,
 * 0 .. 1, linear; 1 each if it has none. `area`: of texture coordinates that a pixel covers, which
 * chooses the level: the texels of it nearest to a pixel in size; 0: level 0.
 * PLT_OK, or what a tile's fetch failed with: *to is then not set. Cost: up to four tiles. */
int plt_texture_sample(plt_textures *textures, uint32_t material, const float texcoord[2],
                       float area, float to[3]);

#endif
#endif
