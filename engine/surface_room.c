/* surface_room - see surface_room.h; and hits that ask for it
 *
 * SPDX-License-Identifier: MIT */
#include "engine/surface_room.h"

#if PLT_WITH_SURFACE

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/fetch.h"
#include "engine/image/further.h"
#include "engine/planelet_crc32.h"
#include "engine/scene/surface_place.h"
#include "engine/surface/surface_corners.h"

/* Where a section lies in a mapped image, or copied to *room, which is then behind it. */
static int read_section(const plt_engine *e, const plt_section *s, unsigned char **room,
                        const unsigned char **bytes, plt_fault *fault) {
    *bytes = NULL;
    if (s == NULL) {
        return PLT_OK;
    }
    if (e->source.mapped != NULL) {
        *bytes = (const unsigned char *)e->source.mapped + s->offset;
    } else {
        const int status = plt_fetch(&e->source, s->offset, *room, s->bytes, fault);
        if (status != PLT_OK) {
            return status;
        }
        *bytes = *room;
        *room += s->bytes;
    }
    return plt_crc32(0, *bytes, s->bytes) == s->crc
               ? PLT_OK
               : plt_refused(fault, PLT_R13_SECTION_CRC, s->offset,
                             "a section is damaged (checksum)");
}

#if PLT_WITH_TEXCOORDS
static int read_texcoords(plt_engine *e, const plt_header *h, unsigned char **room,
                          plt_fault *fault) {
    plt_surface_data *d = &e->scene.surface;
    const plt_section *s = plt_further_section(h, PLT_SECTION_TEXCOORDS);
    const unsigned char *bytes;
    const int status = read_section(e, s, room, &bytes, fault);
    d->has_texcoords = s != NULL;
    return status == PLT_OK && s != NULL ? plt_texcoords_set(&d->texcoords, s, bytes, fault)
                                         : status;
}
#endif

int plt_surface_room_set(plt_engine *e, const plt_header *h, void *const part[PLT_PARTS_COUNT],
                         plt_fault *fault) {
    plt_surface_data *d = &e->scene.surface;
    const unsigned char *normals = NULL, *colours = NULL;
    unsigned char *room = part[PLT_PART_SURFACE];
    if (!e->options.surface) {
        return PLT_OK;
    }
    int status =
        read_section(e, plt_further_section(h, PLT_SECTION_NORMALS), &room, &normals, fault);
    if (status == PLT_OK) {
        status =
            read_section(e, plt_further_section(h, PLT_SECTION_COLOURS), &room, &colours, fault);
    }
    status = status == PLT_OK ? plt_surface_data_set(d, h, normals, colours, fault) : status;
#if PLT_WITH_TEXCOORDS
    status = status == PLT_OK ? read_texcoords(e, h, &room, fault) : status;
#endif
    if (status != PLT_OK) {
        return status;
    }
    d->is_open = 1;
#if PLT_WITH_GROUPS
    plt_surface_places_set(&e->scene, part[PLT_PART_PLACES]);
#endif
    return PLT_OK;
}

#if PLT_WITH_GROUPS
int plt_surface_at(const plt_engine *e, const plt_hit *hit, plt_surface_point *point) {
    const plt_surface_data *d = &e->scene.surface;
    plt_surface_corners corners;
    plt_record room;
    if (hit->triangle >= d->triangles) { /* 0 if it is not open */
        return PLT_ERR_ARGUMENT;
    }
    plt_surface_corners_set(&corners, d, plt_surface_record(&e->scene, hit->triangle, &room));
    plt_surface_mix(&corners, hit->u, hit->v, point);
    return PLT_OK;
}
#endif

#endif
