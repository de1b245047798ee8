/* open_list - a scene without a tree: all records in one list
 *
 * It is validated as the smallest thesis tree: a root link that is a leaf.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/open_formats.h"
#include "engine/tree/thesis/validate.h"
#include "engine/tree/validate_records.h"

int plt_open_list(const plt_opening *o, const plt_header *header) {
    const void *nodes = NULL, *bytes = NULL; /* of nodes there are none, with a checksum */
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
    const size_t mark = o->arena->used;
    plt_validate_level *levels = plt_opening_cut(o, PLT_PART_VALIDATION);
    if (levels == NULL) {
        return plt_opening_arena_error(o);
    }
    status = plt_tree_validate_counts(header, &tree, levels, o->fault);
    plt_arena_release(o->arena, mark);
    o->scene->list.records = records;
    o->scene->list.count = header->info.triangles;
    return status;
}
