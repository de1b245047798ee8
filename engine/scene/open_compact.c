/* open_compact - scenes of compact blocks
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/header_at.h"
#include "engine/scene/build_compact.h"
#include "engine/scene/compact_tree.h"
#include "engine/scene/counts.h"
#include "engine/scene/open_formats.h"
#include "engine/scene/validate_compact.h"
#include "engine/tree/validate_records.h"

/* Primitive ids of the section are those of the packed mesh. */
static int validate_ids(const plt_opening *o, const plt_section *section) {
    const plt_info *info = &o->scene->info;
    const plt_primitive_ids *n = &o->scene->compact.ids;
    for (uint32_t i = 0; i < info->triangles; i++) {
        const uint32_t word = plt_primitive_word_find(n, i);
        if (plt_primitive_id(word) >= info->source_triangles || plt_primitive_rotation(word) > 2) {
            const uint32_t at = (uint32_t)((uint64_t)i * n->bits >> 3);
            return plt_broken(o->fault, PLT_I19_IDS, section->offset + at,
                              "a primitive id or rotation is out of range");
        }
    }
    return PLT_OK;
}

static int validate_blocks(const plt_opening *o, const plt_section *blocks) {
    plt_info counted;
    int status = plt_compact_validate(o, &counted);
    if (status == PLT_ERR_IMAGE) {
        o->fault->offset += blocks->offset;
    }
    if (status == PLT_OK && !plt_counts_agree(&o->scene->info, &counted)) {
        status = plt_broken(o->fault, PLT_I18_COUNTS, PLT_AT_COUNTS,
                            "the header's counts are not the blocks'");
    }
    return status;
}

/* Sections in the order of the image, so that a source is read from front to back. */
static int read_sections(const plt_opening *o, const plt_header *header) {
    plt_block_tree *t = &o->scene->compact;
    const plt_section *ids = plt_header_section(header, PLT_SECTION_PRIMITIVE_IDS);
    const void *blocks = NULL, *id_bytes = NULL, *records = NULL;
    int status = plt_opening_section(
        o, plt_header_section(header, plt_header_blocks_kind(&header->info)), &blocks);
    if (status == PLT_OK && ids != NULL) {
        status = plt_opening_section(o, ids, &id_bytes);
    }
    if (status == PLT_OK && t->leaf_kind == PLT_LEAF_RECORDS) {
        status =
            plt_opening_section(o, plt_header_section(header, PLT_SECTION_TRIANGLES), &records);
    }
    if (status == PLT_OK && t->leaf_kind == PLT_LEAF_RECORDS) {
        status = plt_records_validate(header, records, o->fault);
    }
    t->bytes = blocks;
    t->ids.bytes = id_bytes;
    t->records = records;
    t->used = header->info.node_bytes + header->info.triangle_bytes;
    return status;
}

static int read_tree(const plt_opening *o, const plt_header *header) {
    const plt_section *ids = plt_header_section(header, PLT_SECTION_PRIMITIVE_IDS);
    int status = read_sections(o, header);
    if (status == PLT_OK) {
        status =
            validate_blocks(o, plt_header_section(header, plt_header_blocks_kind(&header->info)));
    }
    return status == PLT_OK && ids != NULL ? validate_ids(o, ids) : status;
}

int plt_open_compact(const plt_opening *o, const plt_header *header,
                     struct plt_compact_build **build) {
    plt_compact_describe(&o->scene->compact, header);
#if PLT_WITH_BUILDER
    if (header->info.build == PLT_BUILD_DEVICE) {
        return plt_build_compact_begin(o, header, build);
    }
#endif
    (void)build;
    return read_tree(o, header);
}
