/* surface - see surface.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/surface.h"

#include <stdlib.h>
#include <string.h>

#include "engine/image/further.h"
#include "engine/image/header_at.h"
#include "engine/planelet_crc32.h"
#include "engine/surface/octahedral.h"
#include "engine/surface/surface_data.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/image_size.h"
#include "host_tools/pack/palette.h"
#include "host_tools/pack/surface_code.h"
#include "host_tools/pack/surface_making.h"

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
int surface_make_tables(const adding *a, making *m, uint32_t split) {
    size_t positions, corners;
    find_pairs(a, split, &positions, &corners);
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

void surface_set_corners(adding *a, const mesh_corners *c, const palette *colours) {
    for (size_t i = 0; i < a->count; i++) {
        const surface_triangle *t = &a->triangle[i / 3];
        corner *to = &a->corners[i];
        memcpy(to->key, t->key[i % 3], sizeof to->key);
        to->number = 3 * t->id + (uint32_t)(i % 3);
        to->value = colours == NULL ? surface_normal_code(c->normal[to->number])
                                    : palette_index(colours, surface_colour(c->colour[to->number]));
    }
    qsort(a->corners, a->count, sizeof *a->corners, by_key);
}

int surface_make_palette(const adding *a, const mesh_corners *c, palette *p, surface_stats *stats) {
    uint32_t *colour = heap_get(4 * (uint64_t)(a->count + 1));
    for (size_t i = 0; i < a->count && colour != NULL; i++) {
        colour[i] = surface_colour(c->colour[3 * (size_t)a->triangle[i / 3].id + i % 3]);
    }
    const int status = colour == NULL ? -1 : palette_make(p, colour, a->count, PLT_PALETTE_MOST);
    heap_drop(colour);
    stats->colours_kept = p->count;
    stats->colours_distinct = p->distinct;
    stats->colours_off = p->furthest;
    return status == 0 ? 0 : surface_out_of_memory(a);
}

/* ---- bytes ------------------------------------------------------------------------------- */

static uint64_t padded(uint64_t bytes) {
    return (bytes + PLT_SECTION_ALIGN - 1) & ~(uint64_t)(PLT_SECTION_ALIGN - 1);
}

static uint64_t bytes_of(const making *m) {
    const uint64_t thirds = (uint64_t)m->position.third + m->corner.third;
    return m->kind == 0         ? 0
           : m->colours == NULL ? padded(plt_normals_bytes(thirds))
                                : padded(plt_colours_bytes(thirds, m->colours->count));
}

unsigned char *surface_put_entries(unsigned char *to, const retrieval_table *t, uint32_t bytes) {
    for (uint32_t i = 0; i < 3 * t->third; i++) {
        for (uint32_t k = 0; k < bytes; k++) {
            *to++ = (unsigned char)(t->entry[i] >> 8 * k);
        }
    }
    return to;
}

static void put_section(unsigned char *to, const making *m) {
    plt_put_u32(to, m->position.seed);
    plt_put_u32(to + 4, m->position.third);
    plt_put_u32(to + 8, m->corner.seed);
    plt_put_u32(to + 12, m->corner.third);
    unsigned char *at = to + PLT_NORMALS_HEAD;
    if (m->colours != NULL) {
        plt_put_u32(at, m->colours->count);
        at = to + PLT_COLOURS_HEAD;
        for (uint32_t i = 0; i < m->colours->count; i++, at += PLT_PALETTE_BYTES) {
            memcpy(at, m->colours->colour[i], 3);
        }
    }
    surface_put_entries(surface_put_entries(at, &m->position, m->entry_bytes), &m->corner,
                        m->entry_bytes);
}

/* Behind the image, with a table; `made`: by rising kinds. */
static void put_all(unsigned char *bytes, uint32_t end, const making *made, uint32_t count) {
    const uint32_t table_bytes = plt_further_table_bytes(count);
    unsigned char *table = bytes + end;
    uint32_t offset = end + table_bytes;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t size = (uint32_t)bytes_of(&made[i]);
        unsigned char *entry = table + PLT_FURTHER_HEAD + i * PLT_FURTHER_ENTRY;
        put_section(bytes + offset, &made[i]);
        plt_put_u32(entry, made[i].kind);
        plt_put_u32(entry + 4, offset);
        plt_put_u32(entry + 8, size);
        plt_put_u32(entry + 12, plt_crc32(0, bytes + offset, size));
        made[i].stats->bytes = size;
        offset += size;
    }
    plt_put_u32(table, plt_further_check(table, table_bytes));
    plt_put_u32(bytes + PLT_AT_FURTHER, count);
    plt_put_u32(bytes + PLT_AT_IMAGE_BYTES, offset);
    plt_header_seal(bytes);
}

static int append(const adding *a, const making *made, uint32_t count) {
    packed *image = a->image;
    uint64_t size = (uint64_t)image->size + plt_further_table_bytes(count);
    for (uint32_t i = 0; i < count; i++) {
        size += bytes_of(&made[i]);
    }
    const char *remedy = "use --normals none and --colours none, or --reduce";
    if (image_size_check(a->name, image->info.triangles, size, 0, remedy, a->f) != 0) {
        return -1;
    }
    unsigned char *bytes = heap_get_aligned(size);
    if (bytes == NULL) {
        return surface_out_of_memory(a);
    }
    memcpy(bytes, image->bytes, image->size);
    memset(bytes + image->size, 0, (size_t)(size - image->size));
    put_all(bytes, image->size, made, count);
    heap_drop(image->bytes);
    image->bytes = bytes;
    image->size = (uint32_t)size;
    const plt_source source = {.mapped = bytes, .bytes = image->size};
    plt_fault fault;
    return plt_image_info(&source, &image->info, &fault) == PLT_OK
               ? 0
               : fail_set(a->f, a->name, "the finished image is refused: %s; please report this",
                          fault.message);
}

/* ---- all --------------------------------------------------------------------------------- */

static int make_all(adding *a, const mesh_corners *c, surface_stats *stats) {
    making made[2] = {{.entry_bytes = 2}, {.entry_bytes = 1}};
    palette colours = {.count = 0};
    uint32_t count = 0;
    int status = 0;
    if (c->normal != NULL) {
        making *m = &made[count++];
        m->kind = PLT_SECTION_NORMALS;
        m->stats = &stats->normals;
        surface_set_corners(a, c, NULL);
        status = surface_make_tables(a, m, PLT_NORMAL_SPLIT);
    }
    if (status == 0 && c->colour != NULL) {
        making *m = &made[count++];
        *m = (making){.entry_bytes = 1,
                      .kind = PLT_SECTION_COLOURS,
                      .colours = &colours,
                      .stats = &stats->colours};
        status = surface_make_palette(a, c, &colours, stats);
        if (status == 0) {
            surface_set_corners(a, c, &colours);
            status = surface_make_tables(a, m, PLT_COLOUR_SPLIT);
        }
    }
    status = status == 0 && count > 0 ? append(a, made, count) : status;
    for (int i = 0; i < 2; i++) {
        retrieval_free(&made[i].position);
        retrieval_free(&made[i].corner);
    }
    palette_free(&colours);
    return status;
}

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

int surface_add(packed *image, const mesh_corners *c, const char *name, surface_stats *stats,
                fail *f) {
    adding a;
    *stats = (surface_stats){.colours_kept = 0};
    int status = surface_begin(&a, image, name, f);
    status = status == 0 ? make_all(&a, c, stats) : status;
    surface_end(&a);
    return status;
}
