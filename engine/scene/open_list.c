/* open_list - a scene without a tree: all records in one list
 *
 * It is validated as the smallest thesis tree: a root link that is a leaf.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/open_formats.h"
#include "engine/scene/validate_thesis.h"
#include "engine/tree/validate_records.h"

int plt_open_list(const plt_opening *o, const plt_header *header,
                  struct plt_compact_build **build) {
    (void)build;
    const void *nodes = NULL; /* an empty section; only its checksum is checked */
    const void *bytes = NULL;
    int status = plt_opening_section(o, plt_header_section(header, PLT_SECTION_NODES), &nodes);
    if (status == PLT_OK) {
        status = plt_opening_section(o, plt_header_section(header, PLT_SECTION_TRIANGLES), &bytes);
    }
    const plt_record *records = bytes;
    if (status == PLT_OK) {
        status = plt_records_validate(header, records, o->fault);
    }
    if (status != PLT_OK) {
        return status;
    }
    const plt_tree tree = {.records = records,
                           .records_count = header->info.triangles,
                           .treelet_nodes = header->info.treelet_nodes,
                           .root = header->root};
    status = plt_thesis_validate_image(o, header, &tree);
    o->scene->list.records = records;
    o->scene->list.count = header->info.triangles;
    return status;
}
