/* surface_triangles - see surface_triangles.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/surface_triangles.h"

#include "engine/image/header.h"
#include "engine/scene/compact_tree.h"
#include "engine/surface/surface_corners.h"
#include "engine/tree/compact/block_record.h"

static void read_record(surface_triangle *to, const plt_record *r) {
    const uint32_t word = plt_get_u32(&r->word[9]), rotation = plt_primitive_rotation(word);
    float corner[3][3];
    plt_record_corners(r, corner);
    to->id = plt_primitive_id(word);
    for (uint32_t j = 0; j < 3; j++) {
        plt_surface_key(corner[(rotation + j) % 3], to->key[j]);
    }
}

static const unsigned char *section_of(const packed *image, const plt_header *h, uint32_t kind) {
    const plt_section *s = plt_header_section(h, kind);
    return s != NULL ? image->bytes + s->offset : NULL;
}

static void read_blocks(surface_triangle *to, const packed *image, const plt_header *h) {
    plt_block_tree tree = {.used = h->info.node_bytes + h->info.triangle_bytes};
    plt_compact_describe(&tree, h);
    tree.bytes = section_of(image, h, PLT_SECTION_BLOCKS);
    tree.ids.bytes = section_of(image, h, PLT_SECTION_PRIMITIVE_IDS);
    tree.records = (const plt_record *)(const void *)section_of(image, h, PLT_SECTION_TRIANGLES);
    for (uint32_t at = 0, next; at < tree.used; at = next) {
        uint32_t first, count;
        next = plt_block_triangles(&tree, at, &first, &count);
        for (uint32_t i = 0; i < count; i++) {
            plt_record record;
            plt_block_record(&tree, at, i, &record);
            read_record(to++, &record);
        }
    }
}

void surface_triangles_read(surface_triangle *to, const packed *image) {
    plt_header h;
    plt_fault fault;
    if (plt_header_read(&h, image->bytes, image->size, &fault) != PLT_OK) {
        return; /* never: it has just been packed */
    }
    if (h.info.nodes_format == PLT_NODES_COMPACT) {
        read_blocks(to, image, &h);
        return;
    }
    const plt_record *record =
        (const plt_record *)(const void *)section_of(image, &h, PLT_SECTION_TRIANGLES);
    for (uint32_t i = 0; i < h.info.triangles; i++) {
        read_record(&to[i], &record[i]);
    }
}
