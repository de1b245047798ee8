/* surface_making - what normals, colours and texture coordinates of an image are made of: surface.c
 * makes one of all triangles, surface_pages.c one of some after the other
 *
 * SPDX-License-Identifier: MIT */
#ifndef SURFACE_MAKING_H
#define SURFACE_MAKING_H
#include "host_tools/mesh/corners.h"
#include "host_tools/pack/pack.h"
#include "host_tools/pack/palette.h"
#include "host_tools/pack/retrieval_build.h"
#include "host_tools/pack/surface_stats.h"
#include "host_tools/pack/surface_triangles.h"
#include "host_tools/pack/texcoord_code.h"

/* A corner of a triangle, and what it has. */
typedef struct corner {
    uint32_t key[3], value, number; /* number: 3 * primitive id + corner */
} corner;

/* One section in the making. */
typedef struct making {
    const mesh_corners *c;
    uint32_t kind, bits; /* bits: of an entry */
    uint32_t split;      /* the value which says that a position does not tell */
    surface_section *stats;
    palette colours;         /* of kind PLT_SECTION_COLOURS */
    texcoord_code texcoords; /* of kind PLT_SECTION_TEXCOORDS */
    retrieval_table position, corner;
} making;

typedef struct adding {
    packed *image;
    surface_triangle *triangle;
    corner *corners;      /* of all triangles, sorted by key and number */
    retrieval_pair *pair; /* room for twice as many */
    size_t count;         /* of corners */
    const char *name;
    fail *f;
} adding;

/* Room for all of an image, and its triangles; -1: memory is out. In any case surface_end. */
int surface_begin(adding *a, packed *image, const char *name, fail *f);
void surface_end(adding *a);

/* Where in mesh_corners a corner of the image is. */
static inline size_t surface_source(const adding *a, size_t i) {
    return 3 * (size_t)a->triangle[i / 3].id + i % 3;
}

/* What to say of it; -1. */
int surface_out_of_memory(const adding *a);

/* Sets a->corners to those of its a->count / 3 triangles, with what `m` is of. */
void surface_set_corners(adding *a, making *m);

/* Both tables of those. -1: memory is out. */
int surface_make_tables(const adding *a, making *m);

/* Of all colours, which may be `near` off before there are more than PALETTE_FEW; bits and split of
 * `m` follow. Likewise. */
int surface_make_palette(const adding *a, making *m, uint32_t near, surface_stats *stats);

/* Steps of all texture coordinates; likewise. */
void surface_make_steps(const adding *a, making *m);

/* ... into the head of their section, or of pages. */
void surface_put_steps(unsigned char *head, const making *m);

/* A table's entries of so many bits each, the lowest first, over zeros; returns what is behind
 * them. */
unsigned char *surface_put_entries(unsigned char *to, const retrieval_table *t, uint32_t bits);

#endif
