/* surface - see surface.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/surface.h"

#include <stdlib.h>
#include <string.h>

#include "engine/surface/octahedral.h"
#include "engine/surface/surface_data.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/further_add.h"
#include "host_tools/pack/image_size.h"
#include "host_tools/pack/palette.h"
#include "host_tools/pack/retrieval_build.h"
#include "host_tools/pack/surface_code.h"
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

static int out_of_memory(const adding *a) {
    return fail_set(a->f, a->name,
                    "%zu corners: out of memory for their normals and colours; pack on a larger "
                    "machine",
                    a->count);
}

static int by_key(const void *a, const void *b) {
    const corner *x = a, *y = b;
    for (int i = 0; i < 3; i++) {
        if (x->key[i] != y->key[i]) {
            return x->key[i] < y->key[i] ? -1 : 1;
        }
    }
    return (x->number > y->number) - (x->number < y->number);
}

/* ---- tables ------------------------------------------------------------------------------ */

/* The corners from `i` on that lie in one position; `same`: what they have is the same. */
static size_t end_of(const adding *a, size_t i, int *same) {
    size_t end = i + 1;
    *same = 1;
    while (end < a->count && memcmp(a->corners[end].key, a->corners[i].key, 12) == 0) {
        *same &= a->corners[end].value == a->corners[i].value;
        end++;
    }
    return end;
}

/* Pairs of corners begin .. end - 1, from `pairs` on; how many there are then. */
static size_t put_corners(const adding *a, size_t begin, size_t end, size_t pairs) {
    for (size_t i = begin; i < end; i++) {
        const corner *c = &a->corners[i];
        if (i == begin || c->number != c[-1].number) { /* a triangle may be there twice */
            a->pair[pairs++] = (retrieval_pair){{c->number / 3, c->number % 3, 0}, c->value};
        }
    }
    return pairs;
}

/* Positions first, then corners that positions do not tell. */
static void find_pairs(const adding *a, uint32_t split, size_t *positions, size_t *corners) {
    int same;
    *positions = *corners = 0;
    for (size_t i = 0; i < a->count; i = end_of(a, i, &same)) {
        end_of(a, i, &same);
        const corner *c = &a->corners[i];
        a->pair[(*positions)++] =
            (retrieval_pair){{c->key[0], c->key[1], c->key[2]}, same ? c->value : split};
    }
    size_t pairs = *positions;
    for (size_t i = 0, end; i < a->count; i = end) {
        end = end_of(a, i, &same);
        pairs = same ? pairs : put_corners(a, i, end, pairs);
    }
    *corners = pairs - *positions;
}

/* Where most positions are split, all corners by themselves take less. */
static int make_tables(const adding *a, making *m) {
    size_t positions, corners;
    find_pairs(a, m->split, &positions, &corners);
    if (retrieval_third(positions) + retrieval_third(corners) > retrieval_third(a->count)) {
        positions = 0;
        corners = 0;
        for (size_t i = 0, end; i < a->count; i = end) {
            int same;
            end = end_of(a, i, &same);
            corners = put_corners(a, i, end, corners);
        }
    }
    m->stats->positions = positions;
    m->stats->split = corners;
    return retrieval_build(&m->position, a->pair, positions) == 0 &&
                   retrieval_build(&m->corner, a->pair + positions, corners) == 0
               ? 0
               : out_of_memory(a);
}

/* ---- values ------------------------------------------------------------------------------ */

/* Where in mesh_corners a corner of the image is. */
static size_t source_of(const adding *a, size_t i) {
    return 3 * (size_t)a->triangle[i / 3].id + i % 3;
}

static uint32_t value_of(making *m, size_t source) {
    const mesh_corners *c = m->c;
    switch (m->kind) {
    case PLT_SECTION_NORMALS:
        return surface_normal_code(c->normal[source]);
    case PLT_SECTION_COLOURS:
        return palette_index(&m->colours, surface_colour(c->colour[source]));
    default:
        return texcoord_code_value(&m->texcoords, c->texcoord[0][source], c->texcoord[1][source]);
    }
}

static void set_corners(adding *a, making *m) {
    for (size_t i = 0; i < a->count; i++) {
        corner *to = &a->corners[i];
        memcpy(to->key, a->triangle[i / 3].key[i % 3], sizeof to->key);
        to->number = (uint32_t)source_of(a, i);
        to->value = value_of(m, to->number);
    }
    qsort(a->corners, a->count, sizeof *a->corners, by_key);
}

static int make_palette(const adding *a, making *m, surface_stats *stats) {
    palette *p = &m->colours;
    uint32_t *colour = heap_get(4 * (uint64_t)(a->count + 1));
    for (size_t i = 0; i < a->count && colour != NULL; i++) {
        colour[i] = surface_colour(m->c->colour[source_of(a, i)]);
    }
    const int status =
        colour == NULL ? -1 : palette_make(p, colour, a->count, SURFACE_COLOURS_NEAR);
    heap_drop(colour);
    stats->colours_kept = p->count;
    stats->colours_distinct = p->distinct;
    stats->colours_off = p->furthest;
    stats->colours_mean = p->mean;
    m->bits = plt_colour_bits(p->count);
    m->split = plt_colour_split(p->count);
    return status == 0 ? 0 : out_of_memory(a);
}

static void make_steps(const adding *a, making *m) {
    m->texcoords = texcoord_code_begin();
    m->bits = m->c->has_fine_texcoords ? TEXCOORD_BITS_FINE : TEXCOORD_BITS;
    for (size_t i = 0; i < a->count; i++) {
        const size_t at = source_of(a, i);
        texcoord_code_add(&m->texcoords, m->c->texcoord[0][at], m->c->texcoord[1][at]);
    }
    texcoord_code_end(&m->texcoords, m->bits);
    m->split = plt_texcoord_split(&m->texcoords.steps);
}

/* ---- bytes ------------------------------------------------------------------------------- */

enum { HEAD_MOST = PLT_COLOURS_HEAD + PALETTE_MANY * PLT_PALETTE_BYTES };

/* All of a section but the entries; where these begin. */
static uint32_t put_head(unsigned char *to, const making *m) {
    plt_put_u32(to, m->position.seed);
    plt_put_u32(to + 4, m->position.third);
    plt_put_u32(to + 8, m->corner.seed);
    plt_put_u32(to + 12, m->corner.third);
    if (m->kind == PLT_SECTION_COLOURS) {
        plt_put_u32(to + 16, m->colours.count);
        for (uint32_t i = 0; i < m->colours.count; i++) {
            memcpy(to + PLT_COLOURS_HEAD + i * PLT_PALETTE_BYTES, m->colours.colour[i], 3);
        }
        return PLT_COLOURS_HEAD + m->colours.count * PLT_PALETTE_BYTES;
    }
    for (uint32_t a = 0; a < 2 && m->kind == PLT_SECTION_TEXCOORDS; a++) {
        plt_put_u32(to + PLT_TEXCOORDS_AT_BITS + 4 * a, m->texcoords.steps.bits[a]);
        plt_put_float(to + PLT_TEXCOORDS_AT_FROM + 4 * a, m->texcoords.steps.from[a]);
        plt_put_float(to + PLT_TEXCOORDS_AT_STEP + 4 * a, m->texcoords.steps.step[a]);
    }
    return m->kind == PLT_SECTION_NORMALS ? PLT_NORMALS_HEAD : PLT_TEXCOORDS_HEAD;
}

/* Bit by bit, the lowest first, over zeros. */
static unsigned char *put_entries(unsigned char *to, const retrieval_table *t, uint32_t bits) {
    for (uint64_t i = 0; i < 3 * (uint64_t)t->third; i++) {
        const uint64_t at = i * bits, shifted = (uint64_t)t->entry[i] << at % 8;
        for (uint32_t k = 0; k < (at % 8 + bits + 7) / 8; k++) {
            to[at / 8 + k] |= (unsigned char)(shifted >> 8 * k);
        }
    }
    return to + plt_retrieval_bytes(t->third, bits);
}

static uint64_t padded(uint64_t bytes) {
    return (bytes + PLT_SECTION_ALIGN - 1) & ~(uint64_t)(PLT_SECTION_ALIGN - 1);
}

/* Among those that the image has, by their kinds. */
static int append(const adding *a, const making *m) {
    const char *remedy = "use --normals none, --colours none and --texcoords none, or --reduce";
    const uint64_t room = padded(HEAD_MOST + plt_retrieval_bytes(m->position.third, m->bits) +
                                 plt_retrieval_bytes(m->corner.third, m->bits));
    packed *image = a->image;
    if (image_size_check(a->name, image->info.triangles, image->size + room + FURTHER_ADD_MORE, 0,
                         remedy, a->f) != 0) {
        return -1;
    }
    unsigned char *bytes = heap_get_zeroed(room);
    if (bytes == NULL) {
        return out_of_memory(a);
    }
    unsigned char *end = bytes + put_head(bytes, m);
    end = put_entries(end, &m->position, m->bits);
    end = put_entries(end, &m->corner, m->bits);
    const uint32_t size = (uint32_t)padded((uint64_t)(end - bytes));
    const int status = further_add(image, m->kind, bytes, size, a->name, a->f);
    m->stats->bytes = status == 0 ? size : 0;
    heap_drop(bytes);
    return status;
}

/* ---- all --------------------------------------------------------------------------------- */

static int make_section(adding *a, making *m) {
    set_corners(a, m);
    const int status = make_tables(a, m) == 0 ? append(a, m) : -1;
    retrieval_free(&m->position);
    retrieval_free(&m->corner);
    return status;
}

static int make_normals(adding *a, const mesh_corners *c, surface_stats *stats) {
    making m = {.c = c,
                .kind = PLT_SECTION_NORMALS,
                .bits = PLT_NORMAL_BITS,
                .split = PLT_NORMAL_SPLIT,
                .stats = &stats->normals};
    return make_section(a, &m);
}

static int make_colours(adding *a, const mesh_corners *c, surface_stats *stats) {
    making m = {.c = c, .kind = PLT_SECTION_COLOURS, .stats = &stats->colours};
    const int status = make_palette(a, &m, stats) == 0 ? make_section(a, &m) : -1;
    palette_free(&m.colours);
    return status;
}

static int make_texcoords(adding *a, const mesh_corners *c, surface_stats *stats) {
    making m = {.c = c, .kind = PLT_SECTION_TEXCOORDS, .stats = &stats->texcoords};
    make_steps(a, &m);
    const int status = make_section(a, &m);
    stats->texcoords_off = m.texcoords.off;
    return status;
}

static int make_all(adding *a, const mesh_corners *c, surface_stats *stats) {
    int status = c->normal != NULL ? make_normals(a, c, stats) : 0;
    status = status == 0 && c->colour != NULL ? make_colours(a, c, stats) : status;
    return status == 0 && c->texcoord[0] != NULL ? make_texcoords(a, c, stats) : status;
}

int surface_add(packed *image, const mesh_corners *c, const char *name, surface_stats *stats,
                fail *f) {
    const uint64_t count = 3 * (uint64_t)image->info.triangles;
    adding a = {.image = image, .count = (size_t)count, .name = name, .f = f};
    *stats = (surface_stats){.colours_kept = 0};
    a.triangle = heap_get((count / 3 + 1) * sizeof *a.triangle);
    a.corners = heap_get((count + 1) * sizeof *a.corners);
    a.pair = heap_get(2 * (count + 1) * sizeof *a.pair);
    int status = 0;
    if (a.triangle == NULL || a.corners == NULL || a.pair == NULL) {
        status = out_of_memory(&a);
    } else {
        surface_triangles_read(a.triangle, image);
        status = make_all(&a, c, stats);
    }
    heap_drop(a.triangle);
    heap_drop(a.corners);
    heap_drop(a.pair);
    return status;
}
