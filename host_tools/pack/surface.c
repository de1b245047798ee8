/* surface - see surface.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/surface.h"

#include <string.h>

#include "engine/surface/octahedral.h"
#include "engine/surface/surface_data.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/further_add.h"
#include "host_tools/pack/image_size.h"
#include "host_tools/pack/palette.h"
#include "host_tools/pack/retrieval_build.h"
#include "host_tools/pack/surface_code.h"
#include "host_tools/pack/surface_making.h"

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
    if (m->kind == PLT_SECTION_TEXCOORDS) {
        surface_put_steps(to, m);
    }
    return m->kind == PLT_SECTION_NORMALS ? PLT_NORMALS_HEAD : PLT_TEXCOORDS_HEAD;
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
        return surface_out_of_memory(a);
    }
    unsigned char *end = bytes + put_head(bytes, m);
    end = surface_put_entries(end, &m->position, m->bits);
    end = surface_put_entries(end, &m->corner, m->bits);
    const uint32_t size = (uint32_t)padded((uint64_t)(end - bytes));
    const int status = further_add(image, m->kind, bytes, size, a->name, a->f);
    m->stats->bytes = status == 0 ? size : 0;
    heap_drop(bytes);
    return status;
}

/* ---- all --------------------------------------------------------------------------------- */

static int make_section(adding *a, making *m) {
    surface_set_corners(a, m);
    const int status = surface_make_tables(a, m) == 0 ? append(a, m) : -1;
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
    const int status =
        surface_make_palette(a, &m, SURFACE_COLOURS_NEAR, stats) == 0 ? make_section(a, &m) : -1;
    palette_free(&m.colours);
    return status;
}

static int make_texcoords(adding *a, const mesh_corners *c, surface_stats *stats) {
    making m = {.c = c, .kind = PLT_SECTION_TEXCOORDS, .stats = &stats->texcoords};
    surface_make_steps(a, &m);
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
    adding a;
    *stats = (surface_stats){.colours_kept = 0};
    int status = surface_begin(&a, image, name, f);
    if (status == 0) {
        status = make_all(&a, c, stats);
    }
    surface_end(&a);
    return status;
}
