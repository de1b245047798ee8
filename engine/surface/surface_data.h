/* surface_data - the normals and colours of an image, found by where corners are
 *
 * Triangles that meet share what they have in common: a corner's position, its floats as they are
 * in the scene, is a key (retrieval.h) of its normal. Where triangles that meet in a position
 * differ, a crease, the value says so, and triangle and corner are the key. So neither triangles
 * nor corners have a number of a vertex.
 *
 * Invariant: once plt_surface_data_set has returned PLT_OK, all entries that any key leads to lie
 * in their sections; whatever they hold is a normal, or a colour of the palette.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SURFACE_SURFACE_DATA_H
#define PLT_SURFACE_SURFACE_DATA_H

#include "engine/image/header.h"
#include "engine/surface/surface_tables.h"
#include "engine/surface/texcoords.h"

#if PLT_WITH_SURFACE

/* What a section of normals begins with, and one of colours: behind that is the palette. */
enum {
    PLT_NORMALS_HEAD = 16,
    PLT_NORMAL_BITS = 16,
    PLT_COLOURS_HEAD = 32,
    PLT_PALETTE_BYTES = 4,
    PLT_PALETTE_SMALL = 255, /* up to so many colours an entry is a byte */
    PLT_PALETTE_MOST = 2047
};

typedef struct plt_surface_data {
    plt_surface_tables normals, colours;
    const unsigned char *palette; /* red, green, blue, 0 each */
    uint32_t palette_count;
    const uint32_t *place;  /* by primitive id (scene/surface_place.h) */
    const uint16_t *within; /* of compact blocks; else NULL */
    uint32_t triangles;     /* ids are below this; 0: they are not to be found by it */
    uint8_t is_open;        /* plt_options.surface */
    uint8_t has_normals, has_colours;
#if PLT_WITH_TEXCOORDS
    uint8_t has_texcoords;
    plt_texcoords texcoords;
#endif
} plt_surface_data;

/* `normals`, `colours`: the sections' bytes, or NULL. R18 refuses heads that do not fit them. */
int plt_surface_data_set(plt_surface_data *d, const plt_header *header,
                         const unsigned char *normals, const unsigned char *colours,
                         plt_fault *fault);

/* Bits of an entry with a palette of so many colours. */
static inline uint32_t plt_colour_bits(uint32_t palette) {
    return palette <= PLT_PALETTE_SMALL ? 8 : 11;
}

/* The entry that is none of it: triangles that meet in a corner have different colours. */
static inline uint32_t plt_colour_split(uint32_t palette) {
    return palette <= PLT_PALETTE_SMALL ? PLT_PALETTE_SMALL : PLT_PALETTE_MOST;
}

/* Bytes of sections with such a head, padding not included. */
static inline uint64_t plt_normals_bytes(const unsigned char *head) {
    return PLT_NORMALS_HEAD + plt_surface_tables_bytes(head, PLT_NORMAL_BITS);
}

static inline uint64_t plt_colours_bytes(const unsigned char *head, uint32_t palette) {
    return PLT_COLOURS_HEAD + (uint64_t)palette * PLT_PALETTE_BYTES +
           plt_surface_tables_bytes(head, plt_colour_bits(palette));
}

#endif
#endif
