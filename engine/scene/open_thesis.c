/* open_thesis - scenes of thesis nodes and float records
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/build_thesis.h"
#include "engine/scene/open_formats.h"
#include "engine/tree/thesis/validate.h"
#include "engine/tree/validate_records.h"

static void describe(const plt_opening *o, const plt_header *header) {
    plt_tree *tree = &o->scene->thesis;
    tree->node_slots = header->info.node_slots;
    tree->records_count = header->info.triangles;
    tree->treelet_nodes = header->info.treelet_nodes;
    tree->root = header->root;
}

static int validate(const plt_opening *o, const plt_header *header) {
    const plt_tree *tree = &o->scene->thesis;
    const size_t mark = o->arena->used;
    plt_validate_level *levels = plt_opening_cut(o, PLT_PART_VALIDATION);
    if (levels == NULL) {
        return plt_opening_arena_error(o);
    }
    int status = plt_planes_validate(header, tree->nodes, o->fault);
    if (status == PLT_OK) {
        status = plt_tree_validate_counts(header, tree, levels, o->fault);
    }
    plt_arena_release(o->arena, mark);
    return status;
}

static int read_tree(const plt_opening *o, const plt_header *header) {
    const void *nodes = NULL, *records = NULL;
    int status = plt_opening_section(o, plt_header_section(header, PLT_SECTION_NODES), &nodes);
    if (status == PLT_OK) {
        status =
            plt_opening_section(o, plt_header_section(header, PLT_SECTION_TRIANGLES), &records);
    }
    if (status == PLT_OK) {
        status = plt_records_validate(header, records, o->fault);
    }
    o->scene->thesis.nodes = nodes;
    o->scene->thesis.records = records;
    return status == PLT_OK ? validate(o, header) : status;
}

int plt_open_thesis(const plt_opening *o, const plt_header *header) {
    describe(o, header);
#if PLT_WITH_BUILDER
    if (header->info.build == PLT_BUILD_DEVICE) {
        return plt_build_thesis(o, header);
    }
#endif
    return read_tree(o, header);
}
