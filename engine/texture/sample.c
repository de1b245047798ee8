/* sample - see sample.h
 *
 * Source of mip levels: L. Williams, "Pyramidal parametrics", 1983.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/texture/sample.h"

#if PLT_WITH_TEXTURE

#include "engine/base/linear.h"
#include "engine/texture/texel.h"

/* 1/256 of a texel: the weights of neighbours. A level's sides are at most 2^14, so positions are
 * at most 2^22, exact in a float. */
enum { STEPS = 256 };
#define FAR 4194304.0f /* 2^22: beyond that a coordinate has no fraction to speak of */

/* A level of a texture. */
typedef struct level {
    uint32_t side[2], first; /* first: of its tiles */
    uint32_t along;          /* tiles in a row */
    unsigned shift;          /* of a tile's side */
    uint8_t format, clamp;
} level;

/* A coordinate as a position of 0 .. side * STEPS. */
static uint32_t position(float x, uint32_t side, uint8_t clamp) {
    float part = x > -FAR && x < FAR ? x : 0.0f; /* of NaN 0 */
    if (clamp) {
        part = x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f;
    } else {
        part = part - (float)(int32_t)part;
        part = part < 0.0f ? part + 1.0f : part;
    }
    return (uint32_t)(int32_t)(part * (float)(side * STEPS));
}

/* A texel's number that may be one beyond either end. */
static uint32_t inside(int32_t i, uint32_t side, uint8_t clamp) {
    const int32_t last = (int32_t)side - 1;
    if (clamp) {
        return (uint32_t)(i < 0 ? 0 : i > last ? last : i);
    }
    return (uint32_t)(i < 0 ? last : i > last ? 0 : i);
}

/* Levels halve the sides, so the texels that a pixel covers quarter: those of 1/2 to 2 are nearest
 * to one. */
static void choose(const plt_texture *t, const plt_paint *p, float area, level *l) {
    const float scaled = area * __builtin_fabsf(p->scale[0] * p->scale[1]);
    float texels = scaled * ((float)t->width * (float)t->height);
    l->shift = plt_texture_tile_shift(t->format);
    l->format = t->format;
    l->clamp = p->clamp;
    l->first = t->first;
    l->side[0] = t->width;
    l->side[1] = t->height;
    for (unsigned i = 1; i < t->levels && texels > 2.0f; i++) { /* false for NaN */
        l->first += plt_texture_tiles_along(l->side[0], l->shift) *
                    plt_texture_tiles_along(l->side[1], l->shift);
        l->side[0] = plt_texture_halved(l->side[0]);
        l->side[1] = plt_texture_halved(l->side[1]);
        texels = texels * 0.25f;
    }
    l->along = plt_texture_tiles_along(l->side[0], l->shift);
}

/* Adds the light of a texel, `weight` times. */
static int add_texel(plt_tiles *tiles, const level *l, uint32_t x, uint32_t y, uint32_t weight,
                     uint32_t sum[3]) {
    const unsigned char *tile;
    uint8_t rgb[3];
    if (weight == 0) {
        return PLT_OK;
    }
    const int status =
        plt_tiles_get(tiles, l->first + (y >> l->shift) * l->along + (x >> l->shift), &tile);
    if (status != PLT_OK) {
        return status;
    }
    if (l->format == PLT_TEXTURE_BLOCKS) {
        plt_texel_block(tile, x, y, rgb);
    } else {
        plt_texel_rgb565(tile, x, y, rgb);
    }
    for (int c = 0; c < 3; c++) {
        sum[c] += weight * plt_linear[rgb[c]];
    }
    return PLT_OK;
}

/* The two texels on both sides of a position, and the weight of the second, of STEPS. */
static void neighbours(uint32_t at, uint32_t side, uint8_t clamp, uint32_t texel[2],
                       uint32_t weight[2]) {
    const uint32_t shifted = at + STEPS / 2;
    const int32_t second = (int32_t)(shifted / STEPS);
    texel[0] = inside(second - 1, side, clamp);
    texel[1] = inside(second, side, clamp);
    weight[1] = shifted % STEPS;
    weight[0] = STEPS - weight[1];
}

/* Sums of at most STEPS^2 * 65535, below 2^32 - 2^15. */
static int mix_four(plt_tiles *tiles, const level *l, const uint32_t at[2], uint32_t sum[3]) {
    uint32_t texel[2][2], weight[2][2];
    int status = PLT_OK;
    for (int a = 0; a < 2; a++) {
        neighbours(at[a], l->side[a], l->clamp, texel[a], weight[a]);
    }
    for (unsigned i = 0; i < 4 && status == PLT_OK; i++) {
        status = add_texel(tiles, l, texel[0][i & 1u], texel[1][i >> 1],
                           weight[0][i & 1u] * weight[1][i >> 1], sum);
    }
    return status;
}

/* v goes up and rows go down: a row has its lower border, not its upper one. */
static int take_nearest(plt_tiles *tiles, const level *l, const uint32_t at[2], uint32_t sum[3]) {
    const uint32_t x = inside((int32_t)(at[0] / STEPS), l->side[0], l->clamp);
    const uint32_t y = inside((int32_t)((at[1] + STEPS - 1) / STEPS) - 1, l->side[1], l->clamp);
    return add_texel(tiles, l, x, y, STEPS * STEPS, sum);
}

int plt_texture_sample(plt_textures *t, uint32_t material, const float texcoord[2], float area,
                       float to[3]) {
    uint32_t at[2], sum[3] = {0, 0, 0};
    plt_paint p;
    plt_texture texture;
    level l;
    plt_directory_paint(&t->directory, material, &p);
    if (p.texture == 0) {
        to[0] = to[1] = to[2] = 1.0f;
        return PLT_OK;
    }
    plt_directory_texture(&t->directory, p.texture - 1u, &texture);
    choose(&texture, &p, area, &l);
    for (int a = 0; a < 2; a++) {
        at[a] = position(p.scale[a] * texcoord[a] + p.offset[a], l.side[a], p.clamp);
    }
    at[1] = l.side[1] * STEPS - at[1];
    const int status = t->filter == PLT_TEXTURES_NEAREST ? take_nearest(&t->tiles, &l, at, sum)
                                                         : mix_four(&t->tiles, &l, at, sum);
    for (int c = 0; c < 3 && status == PLT_OK; c++) {
        to[c] = (float)((sum[c] + 32768u) >> 16) / 65535.0f;
    }
    return status;
}

#endif
