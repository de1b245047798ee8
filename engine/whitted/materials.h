/* materials - what triangles are made of: the section of SPEC.md, 4.20
 *
 * Invariant: plt_materials_check has been through what is read here, so that an index is below
 * the count and a number in its range.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WHITTED_MATERIALS_H
#define PLT_WHITTED_MATERIALS_H

#include "engine/base/bytes.h"
#include "engine/planelet.h"

#define PLT_MATERIALS_MOST 256u
#define PLT_MATERIAL_BYTES 64u
#define PLT_MATERIALS_HEAD 64u
#define PLT_EXPONENT_MOST 1024u

/* Of a section, in its order. Shares of light are 0 .. 1, red, green and blue. */
typedef struct plt_material {
    float diffuse[3];
    float specular[3];   /* of highlights, and of what a mirror reflects */
    float emission[3];   /* light of its own, 0 .. 2^20 */
    float absorption[3]; /* of glass: light fades by e^(-absorption x) along x, 0 .. 2^20 */
    float index;         /* of refraction, 1 .. 4 */
    float transparency;  /* 0: opaque, 1: clear glass, 0 .. 1 */
    float mirror;        /* reflects so much of `specular` face on, and all of it at a grazing
                          * angle; 0: nothing. 0 .. 1 */
    uint32_t exponent;   /* of highlights, 1 .. PLT_EXPONENT_MOST */
} plt_material;

_Static_assert(sizeof(plt_material) == PLT_MATERIAL_BYTES, "as it lies in an image");

/* Which material a triangle has. */
typedef struct plt_materials {
    const unsigned char *table; /* of materials; NULL: there are none, all are of clay */
    const unsigned char *index; /* behind them */
    uint32_t count, bits;       /* bits: of an index: 1, 2, 4, 8; 0: there are runs */
    uint32_t runs, triangles;
    uint8_t has_glass; /* light passes through some material */
} plt_materials;

/* Bytes of a section, its head and padding included. */
uint64_t plt_materials_bytes(const plt_materials *materials);

/* Those of a section, of an image with so many source triangles. PLT_ERR_IMAGE: it breaks R19;
 * `offset` is where the section begins. */
int plt_materials_read(plt_materials *materials, const unsigned char *section, uint32_t bytes,
                       uint32_t triangles, uint32_t offset, plt_fault *fault);

/* The number of a triangle's material; of one that is not there some number below the count. */
uint32_t plt_materials_find(const plt_materials *materials, uint32_t triangle);

void plt_materials_get(const plt_materials *materials, uint32_t number, plt_material *to);

#endif
