/* surface_triangles - see surface_triangles.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/surface_triangles.h"

#include "engine/image/header.h"
#include "engine/surface/surface_corners.h"

static void read_record(surface_triangle *to, const plt_record *r) {
    const uint32_t word = plt_get_u32(&r->word[9]), rotation = plt_primitive_rotation(word);
    float corner[3][3];
    plt_record_corners(r, corner);
    to->id = plt_primitive_id(word);
    for (uint32_t j = 0; j < 3; j++) {
        plt_surface_key(corner[(rotation + j) % 3], to->key[j]);
    }
}

void surface_triangles_read(surface_triangle *to, const packed *image) {
    plt_header h;
    plt_fault fault;
    if (plt_header_read(&h, image->bytes, image->size, &fault) != PLT_OK) {
        return; /* never: it has just been packed */
    }
    const plt_section *s = plt_header_section(&h, PLT_SECTION_TRIANGLES);
    const plt_record *record = (const plt_record *)(const void *)(image->bytes + s->offset);
    for (uint32_t i = 0; i < h.info.triangles; i++) {
        read_record(&to[i], &record[i]);
    }
}
