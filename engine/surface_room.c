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

/* Of an id that no record has, which is none of a hit, the first; of one that two have, either. */
static void set_places(plt_engine *e, uint32_t *place) {
    const plt_record *records = plt_scene_records(&e->scene);
    const uint32_t count = e->scene.info.triangles;
    for (uint32_t i = 0; i < count; i++) {
        place[i] = 0;
    }
    for (uint32_t i = 0; i < count && records != NULL; i++) {
        place[plt_primitive_id(plt_get_u32(&records[i].word[9]))] = i;
    }
}

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
    if (status != PLT_OK) {
        return status;
    }
    d->is_open = 1;
#if PLT_WITH_GROUPS
    set_places(e, part[PLT_PART_PLACES]);
    d->place = part[PLT_PART_PLACES];
    d->triangles = e->scene.info.triangles;
#endif
    return PLT_OK;
}

#if PLT_WITH_GROUPS
int plt_surface_at(const plt_engine *e, const plt_hit *hit, plt_surface_point *point) {
    const plt_surface_data *d = &e->scene.surface;
    const plt_record *records = plt_scene_records(&e->scene);
    plt_surface_corners corners;
    if (!d->is_open || records == NULL || hit->triangle >= d->triangles) {
        return PLT_ERR_ARGUMENT;
    }
    plt_surface_corners_set(&corners, d, &records[d->place[hit->triangle]]);
    plt_surface_mix(&corners, hit->u, hit->v, point);
    return PLT_OK;
}
#endif

#endif
