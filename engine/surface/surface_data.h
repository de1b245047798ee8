/* surface_data - the normals, colours and texture coordinates of an image, found by where corners
 * are
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

#if PLT_WITH_PAGES
/* ... of so many triangles each (surface_pages.h). */
typedef struct plt_surface_pages {
    const unsigned char *resident; /* the section, if it is there as a whole; else NULL */
    uint32_t at, bytes;            /* where it lies in the image, and how long it is */
    uint32_t chunks_at, pages_at;  /* of it: the directory, and the pages */
    uint32_t pages;
    uint8_t shift;         /* a page has 2^shift triangles, in the order of the image */
    uint8_t has;           /* bits of surface_pages.h */
    uint8_t texcoord_bits; /* of an entry of texture coordinates */
} plt_surface_pages;
#endif

typedef struct plt_surface_data {
#if PLT_WITH_PAGES
    union {
        struct {
            plt_surface_tables normals, colours;
        };
        plt_surface_pages pages; /* if is_paged */
    };
#else
    plt_surface_tables normals, colours;
#endif
    const unsigned char *palette; /* red, green, blue, 0 each */
    uint32_t palette_count;
    const uint32_t *place;  /* by primitive id (scene/surface_place.h) */
    const uint16_t *within; /* of compact blocks; else NULL */
    uint32_t triangles;     /* ids are below this; 0: they are not to be found by it */
    uint8_t is_open;        /* plt_options.surface */
    uint8_t has_normals, has_colours;
#if PLT_WITH_PAGES
    uint8_t is_paged; /* page by page; else the tables are those of all triangles */
#endif
#if PLT_WITH_TEXCOORDS
    uint8_t has_texcoords;
    plt_texcoords texcoords;
#endif
} plt_surface_data;

#if PLT_WITH_PAGES
static inline int plt_surface_is_paged(const plt_surface_data *d) {
    return d->is_paged;
}
#else
static inline int plt_surface_is_paged(const plt_surface_data *d) {
    (void)d;
    return 0;
}
#endif

/* `normals`, `colours`: the sections' bytes, or NULL. R18 refuses heads that do not fit them. */
int plt_surface_data_set(plt_surface_data *d, const plt_header *header,
                         const unsigned char *normals, const unsigned char *colours,
                         plt_fault *fault);

/* Bits of an entry with a palette of so many colours. */
static inline uint32_t plt_colour_bits(uint32_t count) {
    return count <= PLT_PALETTE_SMALL ? 8 : 11;
}

/* The entry that is none of it: triangles that meet in a corner have different colours. */
static inline uint32_t plt_colour_split(uint32_t count) {
    return count <= PLT_PALETTE_SMALL ? PLT_PALETTE_SMALL : PLT_PALETTE_MOST;
}

/* Bytes of sections with such a head, padding not included. */
static inline uint64_t plt_normals_bytes(const unsigned char *head) {
    return PLT_NORMALS_HEAD + plt_surface_tables_bytes(head, PLT_NORMAL_BITS);
}

static inline uint64_t plt_colours_bytes(const unsigned char *head, uint32_t count) {
    return PLT_COLOURS_HEAD + (uint64_t)count * PLT_PALETTE_BYTES +
           plt_surface_tables_bytes(head, plt_colour_bits(count));
}

#endif
#endif
