/* surface_making - what normals and colours of an image are made of: surface.c makes one of all
 * triangles, surface_pages.c one of some after the other
 *
 * SPDX-License-Identifier: MIT */
#ifndef SURFACE_MAKING_H
#define SURFACE_MAKING_H
#include "host_tools/pack/palette.h"
#include "host_tools/pack/retrieval_build.h"
#include "host_tools/pack/surface.h"
#include "host_tools/pack/surface_triangles.h"

/* A corner of a triangle, and what it has. */
typedef struct corner {
    uint32_t key[3], value, number; /* number: 3 * primitive id + corner */
} corner;

/* One section in the making. */
typedef struct making {
    retrieval_table position, corner;
    uint32_t entry_bytes, kind;
    palette *colours; /* NULL: of normals */
    surface_section *stats;
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

/* What to say of it; -1. */
int surface_out_of_memory(const adding *a);

/* Sets a->corners to those of its a->count / 3 triangles, with normals, or colours. */
void surface_set_corners(adding *a, const mesh_corners *c, const palette *colours);

/* Both tables of those; `split`: what a position says that has none. -1: memory is out. */
int surface_make_tables(const adding *a, making *m, uint32_t split);

/* Of all colours. Likewise. */
int surface_make_palette(const adding *a, const mesh_corners *c, palette *p, surface_stats *stats);

/* A table's entries of so many bytes each; returns what is behind them. */
unsigned char *surface_put_entries(unsigned char *to, const retrieval_table *t, uint32_t bytes);

#endif
