/* surface_making - see surface_making.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/surface_making.h"

#include <stdlib.h>
#include <string.h>

#include "engine/surface/surface_data.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/surface_code.h"

int surface_out_of_memory(const adding *a) {
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
int surface_make_tables(const adding *a, making *m) {
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
               : surface_out_of_memory(a);
}

/* ---- values ------------------------------------------------------------------------------ */

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

void surface_set_corners(adding *a, making *m) {
    for (size_t i = 0; i < a->count; i++) {
        corner *to = &a->corners[i];
        memcpy(to->key, a->triangle[i / 3].key[i % 3], sizeof to->key);
        to->number = (uint32_t)surface_source(a, i);
        to->value = value_of(m, to->number);
    }
    qsort(a->corners, a->count, sizeof *a->corners, by_key);
}

int surface_make_palette(const adding *a, making *m, uint32_t near, surface_stats *stats) {
    palette *p = &m->colours;
    uint32_t *colour = heap_get(4 * (uint64_t)(a->count + 1));
    for (size_t i = 0; i < a->count && colour != NULL; i++) {
        colour[i] = surface_colour(m->c->colour[surface_source(a, i)]);
    }
    const int status = colour == NULL ? -1 : palette_make(p, colour, a->count, near);
    heap_drop(colour);
    stats->colours_kept = p->count;
    stats->colours_distinct = p->distinct;
    stats->colours_off = p->furthest;
    stats->colours_mean = p->mean;
    m->bits = plt_colour_bits(p->count);
    m->split = plt_colour_split(p->count);
    return status == 0 ? 0 : surface_out_of_memory(a);
}

void surface_make_steps(const adding *a, making *m) {
    m->texcoords = texcoord_code_begin();
    m->bits = m->c->has_fine_texcoords ? TEXCOORD_BITS_FINE : TEXCOORD_BITS;
    for (size_t i = 0; i < a->count; i++) {
        const size_t at = surface_source(a, i);
        texcoord_code_add(&m->texcoords, m->c->texcoord[0][at], m->c->texcoord[1][at]);
    }
    texcoord_code_end(&m->texcoords, m->bits);
    m->split = plt_texcoord_split(&m->texcoords.steps);
}

/* ---- bytes ------------------------------------------------------------------------------- */

void surface_put_steps(unsigned char *head, const making *m) {
    const plt_texcoords *steps = &m->texcoords.steps;
    for (uint32_t a = 0; a < 2; a++) {
        plt_put_u32(head + PLT_TEXCOORDS_AT_BITS + 4 * a, steps->bits[a]);
        plt_put_float(head + PLT_TEXCOORDS_AT_FROM + 4 * a, steps->from[a]);
        plt_put_float(head + PLT_TEXCOORDS_AT_STEP + 4 * a, steps->step[a]);
    }
}

/* Bit by bit, the lowest first, over zeros. */
unsigned char *surface_put_entries(unsigned char *to, const retrieval_table *t, uint32_t bits) {
    for (uint64_t i = 0; i < 3 * (uint64_t)t->third; i++) {
        const uint64_t at = i * bits, shifted = (uint64_t)t->entry[i] << at % 8;
        for (uint32_t k = 0; k < (at % 8 + bits + 7) / 8; k++) {
            to[at / 8 + k] |= (unsigned char)(shifted >> 8 * k);
        }
    }
    return to + plt_retrieval_bytes(t->third, bits);
}

/* ---- room -------------------------------------------------------------------------------- */

int surface_begin(adding *a, packed *image, const char *name, fail *f) {
    const uint64_t count = 3 * (uint64_t)image->info.triangles;
    *a = (adding){.image = image, .count = (size_t)count, .name = name, .f = f};
    a->triangle = heap_get((count / 3 + 1) * sizeof *a->triangle);
    a->corners = heap_get((count + 1) * sizeof *a->corners);
    a->pair = heap_get(2 * (count + 1) * sizeof *a->pair);
    if (a->triangle == NULL || a->corners == NULL || a->pair == NULL) {
        return surface_out_of_memory(a);
    }
    surface_triangles_read(a->triangle, image);
    return 0;
}

void surface_end(adding *a) {
    heap_drop(a->triangle);
    heap_drop(a->corners);
    heap_drop(a->pair);
}
