/* texcoord_code - texture coordinates in steps, as an image has them (SPEC.md, 4.21)
 *
 * SPDX-License-Identifier: MIT */
#ifndef TEXCOORD_CODE_H
#define TEXCOORD_CODE_H
#include "engine/surface/texcoords.h"

/* Bits of both, in an image of 3 bytes per entry, or 4. */
enum { TEXCOORD_BITS = 24, TEXCOORD_BITS_FINE = 32 };

typedef struct texcoord_code {
    plt_texcoords steps; /* without tables */
    float low[2], high[2];
    double off; /* the most that a coordinate has been off by so far */
} texcoord_code;

/* Of no coordinates. */
texcoord_code texcoord_code_begin(void);
/* Takes one more coordinate in: u and v as mesh_corners has them. All are, before `end`. */
void texcoord_code_add(texcoord_code *t, uint32_t u, uint32_t v);
/* Shares so many bits among both axes, so that neither has steps much larger than the other's. */
void texcoord_code_end(texcoord_code *t, uint32_t bits);
/* The value that is nearest. */
uint32_t texcoord_code_value(texcoord_code *t, uint32_t u, uint32_t v);

#endif
