/* texcoords - where a texture lies on the corners of triangles, found by where these are
 *
 * A value is two numbers of steps, u in its lowest bits and v above them. The greatest u is no
 * coordinate: with a v of 0 it says that triangles which meet in the corner have different ones,
 * with others that it has none.
 *
 * Invariant: once plt_texcoords_set has returned PLT_OK, all entries that any key leads to lie in
 * their section, and whatever they hold, coordinates are within +-PLT_TEXCOORD_MOST.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SURFACE_TEXCOORDS_H
#define PLT_SURFACE_TEXCOORDS_H

#include "engine/image/header.h"
#include "engine/surface/surface_tables.h"

/* What the section begins with, and bits of u, and of v. */
enum { PLT_TEXCOORDS_HEAD = 64, PLT_TEXCOORD_BITS_LEAST = 2, PLT_TEXCOORD_BITS_MOST = 16 };

/* Of what it begins with; pages have the same there (surface_pages.h). */
enum {
    PLT_TEXCOORDS_AT_BITS = 16,
    PLT_TEXCOORDS_AT_FROM = 24,
    PLT_TEXCOORDS_AT_STEP = 32,
    PLT_TEXCOORDS_AT_REST = 40 /* 0 up to its end */
};

#if PLT_WITH_TEXCOORDS

#define PLT_TEXCOORD_MOST 0x1p20f

typedef struct plt_texcoords {
    plt_surface_tables tables;
    uint32_t bits[2];
    float from[2], step[2]; /* a coordinate: from + number * step */
} plt_texcoords;

static inline uint32_t plt_texcoord_split(const plt_texcoords *t) {
    return (1u << t->bits[0]) - 1;
}

/* Of a value that is one; the same bits on every machine. */
static inline void plt_texcoord_decode(const plt_texcoords *t, uint32_t value, float to[2]) {
    const uint32_t u = value & plt_texcoord_split(t), v = value >> t->bits[0];
    to[0] = t->from[0] + (float)u * t->step[0];
    to[1] = t->from[1] + (float)v * t->step[1];
}

/* Bytes of a section with such a head, padding not included. */
static inline uint64_t plt_texcoords_bytes(const unsigned char *head, uint32_t bits) {
    return PLT_TEXCOORDS_HEAD + plt_surface_tables_bytes(head, bits);
}

/* Sets all of `t` but its tables by the 64 bytes that a section, or pages, begin with; 0: they are
 * not what they must be. */
int plt_texcoords_read_head(plt_texcoords *t, const unsigned char *head);

/* `bytes`: those of section `s`. R18 refuses heads that do not fit it. */
int plt_texcoords_set(plt_texcoords *t, const plt_section *s, const unsigned char *bytes,
                      plt_fault *fault);

/* Of a corner, by where it is or by its triangle; 0: it has none. */
int plt_texcoord_find(const plt_texcoords *t, const uint32_t key[3], const uint32_t corner_key[3],
                      float to[2]);

/* Square root of the area that a triangle covers of the texture, over its own; 0 where either
 * vanishes. */
float plt_texcoord_scale(const float corner[3][3], const float texcoord[3][2]);

#endif
#endif
