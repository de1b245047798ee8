/* surface_pages - see surface_pages.h
 *
 * Pages are as large as they may be: positions at their borders are in two of them, or more.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/surface_pages.h"

#include <math.h>
#include <string.h>

#include "engine/planelet_crc32.h"
#include "engine/surface/octahedral.h"
#include "engine/surface/surface_pages.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/further_add.h"
#include "host_tools/pack/image_size.h"
#include "host_tools/pack/surface_making.h"

/* A page's entries of colours are bytes: a palette of more would not do. */
enum { ANY_DISTANCE = 255 };

/* A section in the making. */
typedef struct paging {
    adding all; /* triangles of the image, and room for them */
    const mesh_corners *c;
    making colours;   /* their palette */
    making texcoords; /* their steps */
    surface_stats *stats;
    unsigned char *bytes; /* of the section; room for `room` */
    uint64_t room, used;
    uint32_t shift, pages, has;
} paging;

static uint64_t padded(uint64_t bytes) {
    return (bytes + PLT_SECTION_ALIGN - 1) & ~(uint64_t)(PLT_SECTION_ALIGN - 1);
}

/* `bytes` more behind what is used. */
static int reserve(paging *p, uint64_t bytes) {
    const uint64_t wanted = padded(p->used + bytes);
    if (wanted > p->room) {
        const uint64_t room = 2 * wanted;
        unsigned char *more = heap_resize(p->bytes, room);
        if (more == NULL) {
            return surface_out_of_memory(&p->all);
        }
        memset(more + p->room, 0, (size_t)(room - p->room));
        p->bytes = more;
        p->room = room;
    }
    return 0;
}

/* ---- a page ------------------------------------------------------------------------------ */

/* The tables of some triangles, behind what is used; `of`: kind, bits, split, palette and steps. */
static int put_tables(paging *p, adding *some, const making *of, surface_section *s) {
    surface_section of_page = {0};
    making m = *of;
    m.stats = &of_page;
    surface_set_corners(some, &m);
    p->stats->texcoords_off = fmax(p->stats->texcoords_off, m.texcoords.off);
    int status = surface_make_tables(some, &m);
    const uint64_t bytes = PLT_NORMALS_HEAD + plt_retrieval_bytes(m.position.third, m.bits) +
                           plt_retrieval_bytes(m.corner.third, m.bits);
    status = status == 0 ? reserve(p, bytes) : status;
    if (status == 0) {
        unsigned char *to = p->bytes + p->used;
        plt_put_u32(to, m.position.seed);
        plt_put_u32(to + 4, m.position.third);
        plt_put_u32(to + 8, m.corner.seed);
        plt_put_u32(to + 12, m.corner.third);
        to = surface_put_entries(to + PLT_NORMALS_HEAD, &m.position, m.bits);
        surface_put_entries(to, &m.corner, m.bits);
        p->used += bytes;
        s->positions += of_page.positions;
        s->split += of_page.split;
    }
    retrieval_free(&m.position);
    retrieval_free(&m.corner);
    return status;
}

static int put_normals(paging *p, adding *some) {
    const making of = {
        .c = p->c, .kind = PLT_SECTION_NORMALS, .bits = PLT_NORMAL_BITS, .split = PLT_NORMAL_SPLIT};
    return put_tables(p, some, &of, &p->stats->normals);
}

static int put_page(paging *p, uint32_t page) {
    const uint64_t first = (uint64_t)page << p->shift, begin = p->used;
    const uint64_t left = p->all.image->info.triangles - first, each = 1ull << p->shift;
    adding some = p->all;
    some.triangle += first;
    some.count = (size_t)(3 * (left < each ? left : each));
    int status = reserve(p, PLT_PAGE_HEAD);
    p->used += PLT_PAGE_HEAD;
    if (status == 0 && p->c->normal != NULL) {
        status = put_normals(p, &some);
    }
    if (status == 0 && p->c->colour != NULL) {
        status = put_tables(p, &some, &p->colours, &p->stats->colours);
    }
    if (status == 0 && p->c->texcoord[0] != NULL) {
        status = put_tables(p, &some, &p->texcoords, &p->stats->texcoords);
    }
    if (status == 0) {
        unsigned char *at = p->bytes + begin;
        plt_put_u32(at, plt_pages_check(page, at + PLT_PAGE_HEAD,
                                        (uint32_t)(p->used - begin) - PLT_PAGE_HEAD));
    }
    return status;
}

/* ---- all pages --------------------------------------------------------------------------- */

static uint32_t chunks_of(const paging *p) {
    return (p->pages + PLT_PAGES_IN_CHUNK - 1) / PLT_PAGES_IN_CHUNK;
}

/* Offset `i` of the directory; the last of a chunk is the first of the next one. */
static void put_offset(const paging *p, uint32_t chunks_at, uint32_t i) {
    unsigned char *chunks = p->bytes + chunks_at;
    const uint32_t chunk = i / PLT_PAGES_IN_CHUNK, rest = i % PLT_PAGES_IN_CHUNK;
    if (chunk < chunks_of(p)) {
        plt_put_u32(chunks + chunk * PLT_PAGES_CHUNK + 4 + 4 * rest, (uint32_t)p->used);
    }
    if (rest == 0 && chunk > 0) {
        plt_put_u32(chunks + chunk * PLT_PAGES_CHUNK - 4, (uint32_t)p->used);
    }
}

static void seal(const paging *p, uint32_t chunks_at) {
    for (uint32_t i = 0; i < chunks_of(p); i++) {
        unsigned char *chunk = p->bytes + chunks_at + i * PLT_PAGES_CHUNK;
        plt_put_u32(chunk, plt_pages_check(i, chunk + 4, PLT_PAGES_CHUNK - 4));
    }
    unsigned char *head = p->bytes;
    plt_put_u32(head, p->has);
    plt_put_u32(head + 4, p->shift);
    plt_put_u32(head + 8, p->colours.colours.count);
    for (uint32_t i = 0; i < p->colours.colours.count; i++) {
        memcpy(head + PLT_PAGES_HEAD + i * PLT_PALETTE_BYTES, p->colours.colours.colour[i], 3);
    }
    if ((p->has & PLT_PAGES_TEXCOORDS) != 0) {
        surface_put_steps(head, &p->texcoords);
    }
    plt_put_u32(head + 12, plt_pages_head_check(head, chunks_at));
}

/* With pages of so many triangles; 1: one is too large. */
static int put_all(paging *p) {
    const uint32_t triangles = p->all.image->info.triangles;
    const uint32_t chunks_at = PLT_PAGES_HEAD + p->colours.colours.count * PLT_PALETTE_BYTES;
    p->pages = (uint32_t)(((uint64_t)triangles + (1u << p->shift) - 1) >> p->shift);
    p->stats->normals = p->stats->colours = p->stats->texcoords = (surface_section){0};
    p->used = 0;
    if (p->room > 0) {
        memset(p->bytes, 0, (size_t)p->room);
    }
    int status = reserve(p, chunks_at + (uint64_t)chunks_of(p) * PLT_PAGES_CHUNK);
    p->used = chunks_at + (uint64_t)chunks_of(p) * PLT_PAGES_CHUNK;
    for (uint32_t i = 0; i < p->pages && status == 0; i++) {
        const uint64_t begin = p->used;
        put_offset(p, chunks_at, i);
        status = put_page(p, i);
        if (status == 0 && p->used - begin > PLT_PAGE_BYTES_MOST) {
            return 1;
        }
    }
    for (uint32_t i = p->pages; status == 0 && i <= chunks_of(p) * PLT_PAGES_IN_CHUNK; i++) {
        put_offset(p, chunks_at, i);
    }
    if (status == 0) {
        seal(p, chunks_at);
    }
    return status;
}

static int add_section(paging *p) {
    packed *image = p->all.image;
    const uint64_t size = padded(p->used);
    const char *remedy = "use --normals none, --colours none and --texcoords none, or --reduce";
    if (image_size_check(p->all.name, image->info.triangles, image->size + size + FURTHER_ADD_MORE,
                         0, remedy, p->all.f) != 0) {
        return -1;
    }
    p->stats->pages.bytes = (uint32_t)size;
    p->stats->pages_count = p->pages;
    p->stats->each = 1u << p->shift;
    return further_add(image, PLT_SECTION_PAGES, p->bytes, (uint32_t)size, p->all.name, p->all.f);
}

static int make(paging *p) {
    int status = 0;
    if (p->c->colour != NULL) {
        p->colours = (making){.c = p->c, .kind = PLT_SECTION_COLOURS};
        status = surface_make_palette(&p->all, &p->colours, ANY_DISTANCE, p->stats);
    }
    if (p->c->texcoord[0] != NULL) {
        p->texcoords = (making){.c = p->c, .kind = PLT_SECTION_TEXCOORDS};
        surface_make_steps(&p->all, &p->texcoords);
    }
    p->has = (p->c->normal != NULL ? PLT_PAGES_NORMALS : 0u) |
             (p->c->colour != NULL ? PLT_PAGES_COLOURS : 0u) |
             (p->c->texcoord[0] != NULL ? PLT_PAGES_TEXCOORDS : 0u);
    p->shift++;
    do {
        p->shift--;
        status = status == 0 || status == 1 ? put_all(p) : status;
    } while (status == 1 && p->shift > PLT_PAGE_SHIFT_LEAST);
    return status == 0 ? add_section(p) : -1; /* the smallest pages are never too large */
}

int surface_pages_add(packed *image, const mesh_corners *c, uint32_t shift, const char *name,
                      surface_stats *stats, fail *f) {
    paging p = {.c = c, .stats = stats, .shift = shift};
    *stats = (surface_stats){.colours_kept = 0};
    int status = surface_begin(&p.all, image, name, f);
    if (status == 0) {
        status = make(&p);
    }
    surface_end(&p.all);
    palette_free(&p.colours.colours);
    heap_drop(p.bytes);
    return status;
}
