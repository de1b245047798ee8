/* tint - see tint.h
 *
 * On a surface that is tilted a pixel is longer than it is wide; of both sides the mean chooses the
 * level of a texture.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/texture/tint.h"

#if PLT_WITH_TEXTURE

#include "engine/base/linear.h"
#include "engine/base/srgb.h"

#define TILT_LEAST 0.015625f /* a cosine of 1/64: a surface seen edge on is not all that long */

float plt_texture_area(float width, float scale, float cosine) {
    const float across = width * scale;
    return across * across / (cosine > TILT_LEAST ? cosine : TILT_LEAST);
}

int plt_texture_is_there(const plt_textures *t, uint32_t material) {
    const plt_directory *d = &t->directory;
    return material < d->paints && d->paint[material * PLT_PAINT_ENTRY] != 0;
}

int plt_texture_tint(plt_textures *t, uint32_t material, const float texcoord[2], float area,
                     uint8_t rgb[3]) {
    float texel[3];
    const int status = plt_texture_sample(t, material, texcoord, area, texel);
    for (int c = 0; c < 3 && status == PLT_OK; c++) {
        const float tint = (float)plt_linear[rgb[c]] / 65535.0f;
        rgb[c] = plt_srgb_byte(tint * texel[c]);
    }
    return status;
}

#endif
