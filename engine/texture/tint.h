/* tint - the colour of a surface under its texture
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TEXTURE_TINT_H
#define PLT_TEXTURE_TINT_H

#include "engine/texture/sample.h"

#if PLT_WITH_TEXTURE

/* Texture coordinates that a pixel covers, as an area: it is `width` wide where it meets the
 * surface, which has `scale` of the texture's per its own length, at an angle of that cosine. */
float plt_texture_area(float width, float scale, float cosine);

/* The material has a texture. */
int plt_texture_is_there(const plt_textures *textures, uint32_t material);

/* Multiplies a colour, in sRGB, by the texel of a material, in linear light; by 1 if that has no
 * texture. PLT_OK, or what a tile's fetch failed with: the colour is then as it was. */
int plt_texture_tint(plt_textures *textures, uint32_t material, const float texcoord[2], float area,
                     uint8_t rgb[3]);

#endif
#endif
