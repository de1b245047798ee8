/* surface_room - see surface_room.h; and hits that ask for it
 *
 * SPDX-License-Identifier: MIT */
#include "engine/surface_room.h"

#if PLT_WITH_SURFACE

#include "engine/base/fault.h"
#include "engine/image/fetch.h"
#include "engine/image/further.h"
#include "engine/scene/surface_place.h"
#include "engine/trace/surface_hit.h"

/* A section, of which there is one: where it is mapped, or copied to *room, which is behind it
 * then. */
static int load(const plt_engine *e, const plt_section *s, unsigned char **room,
                const unsigned char **bytes, plt_fault *fault) {
    const int status = plt_further_load(&e->source, s, *room, bytes, fault);
    if (e->source.mapped == NULL) {
        *room += s->bytes;
    }
    return status;
}

static int open_tables(plt_engine *e, const plt_header *h, unsigned char **room, plt_fault *fault) {
    const plt_section *of_normals = plt_further_section(h, PLT_SECTION_NORMALS),
                      *of_colours = plt_further_section(h, PLT_SECTION_COLOURS);
    const unsigned char *normals = NULL, *colours = NULL;
    int status = PLT_OK;
    if (of_normals != NULL) {
        status = load(e, of_normals, room, &normals, fault);
    }
    if (status == PLT_OK && of_colours != NULL) {
        status = load(e, of_colours, room, &colours, fault);
    }
    return status == PLT_OK ? plt_surface_data_set(&e->scene.surface, h, normals, colours, fault)
                            : status;
}

#if PLT_WITH_TEXCOORDS
/* Of a scene that is resident: in front of those of pages. */
static int open_texcoords(plt_engine *e, const plt_header *h, unsigned char **room,
                          plt_fault *fault) {
    plt_surface_data *d = &e->scene.surface;
    const plt_section *s = plt_further_section(h, PLT_SECTION_TEXCOORDS);
    const unsigned char *bytes;
    if (s == NULL || plt_is_streamed(e->scene.format)) {
        return PLT_OK;
    }
#if PLT_WITH_PAGES
    if (d->is_paged) {
        d->pages.has &= (uint8_t)~PLT_PAGES_TEXCOORDS;
    }
#endif
    d->has_texcoords = 1;
    const int status = load(e, s, room, &bytes, fault);
    return status == PLT_OK ? plt_texcoords_set(&d->texcoords, s, bytes, fault) : status;
}
#endif

#if PLT_WITH_PAGES
/* What pages begin with, where it is mapped, or copied. */
static int load_head(const plt_engine *e, const plt_section *s, unsigned char *room,
                     const unsigned char **bytes, plt_fault *fault) {
    const uint32_t count = s->bytes < PLT_PAGES_ROOM ? s->bytes : PLT_PAGES_ROOM;
    if (e->source.mapped != NULL) {
        *bytes = (const unsigned char *)e->source.mapped + s->offset;
        return PLT_OK;
    }
    *bytes = room;
    return plt_fetch(&e->source, s->offset, room, count, fault);
}

static int open_pages(plt_engine *e, const plt_section *s, unsigned char **room, plt_fault *fault) {
    plt_surface_data *d = &e->scene.surface;
    const int is_streamed = plt_is_streamed(e->scene.format);
    const unsigned char *bytes = NULL;
    int status =
        is_streamed ? load_head(e, s, *room, &bytes, fault) : load(e, s, room, &bytes, fault);
    if (status == PLT_OK) {
        status = plt_surface_pages_set(d, s, bytes, !is_streamed, e->scene.info.triangles, fault);
    }
    return status == PLT_OK && !is_streamed
               ? plt_surface_pages_validate(d, 0, d->pages.pages, fault)
               : status;
}

static int open_surface(plt_engine *e, const plt_header *h, unsigned char **room,
                        plt_fault *fault) {
    const plt_section *pages = plt_further_section(h, PLT_SECTION_PAGES);
    const int has_tables = plt_further_section(h, PLT_SECTION_NORMALS) != NULL ||
                           plt_further_section(h, PLT_SECTION_COLOURS) != NULL;
    return pages != NULL && (plt_is_streamed(e->scene.format) || !has_tables)
               ? open_pages(e, pages, room, fault)
               : open_tables(e, h, room, fault);
}
#else
static int open_surface(plt_engine *e, const plt_header *h, unsigned char **room,
                        plt_fault *fault) {
    const int status = open_tables(e, h, room, fault);
    const plt_surface_data *d = &e->scene.surface;
    return status == PLT_OK && !d->has_normals && !d->has_colours &&
                   plt_further_section(h, PLT_SECTION_PAGES) != NULL
               ? plt_limit(fault,
                           "what corners have comes in pages here, and this build of the "
                           "engine has none (PLT_WITH_STREAMED)")
               : status;
}
#endif

int plt_surface_room_set(plt_engine *e, const plt_header *h, void *const part[PLT_PARTS_COUNT],
                         plt_fault *fault) {
    if (!e->options.surface) {
        return PLT_OK;
    }
    unsigned char *room = part[PLT_PART_SURFACE];
    int status = open_surface(e, h, &room, fault);
#if PLT_WITH_TEXCOORDS
    status = status == PLT_OK ? open_texcoords(e, h, &room, fault) : status;
#endif
    if (status != PLT_OK) {
        return status;
    }
    e->scene.surface.is_open = 1;
#if PLT_WITH_GROUPS
    if (!plt_is_streamed(e->scene.format)) {
        plt_surface_places_set(&e->scene, part[PLT_PART_PLACES]);
    }
#endif
    return PLT_OK;
}

#if PLT_WITH_GROUPS
int plt_surface_at(const plt_engine *e, const plt_hit *hit, plt_surface_point *point) {
    const plt_surface_data *d = &e->scene.surface;
    plt_surface_corners corners;
    if (hit->triangle >= d->triangles) { /* 0 if it is not open */
        return PLT_ERR_ARGUMENT;
    }
    plt_surface_of_id(&e->scene, hit->triangle, &corners);
    plt_surface_mix(&corners, hit->u, hit->v, point);
    return PLT_OK;
}
#endif

#endif
