/* open_thesis - scenes of thesis nodes and float records
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/build_thesis.h"
#include "engine/scene/open_formats.h"
#include "engine/scene/validate_thesis.h"
#include "engine/tree/validate_records.h"

static void describe(const plt_opening *o, const plt_header *header) {
    plt_tree *tree = &o->scene->thesis;
    tree->node_slots = header->info.node_slots;
    tree->records_count = header->info.triangles;
    tree->treelet_nodes = header->info.treelet_nodes;
    tree->root = header->root;
}

/* Nodes come last: behind them there may be room for more. */
static int read_tree(const plt_opening *o, const plt_header *header) {
    const void *nodes = NULL, *records = NULL;
    int status =
        plt_opening_section(o, plt_header_section(header, PLT_SECTION_TRIANGLES), &records);
    if (status == PLT_OK) {
        status = plt_opening_section(o, plt_header_section(header, PLT_SECTION_NODES), &nodes);
    }
    if (status == PLT_OK) {
        status = plt_records_validate(header, records, o->fault);
    }
    o->scene->thesis.nodes = nodes;
    o->scene->thesis.records = records;
    return status == PLT_OK ? plt_thesis_validate_image(o, header, &o->scene->thesis) : status;
}

int plt_open_thesis(const plt_opening *o, const plt_header *header,
                    struct plt_compact_build **build) {
    (void)build;
    describe(o, header);
#if PLT_WITH_BUILDER
    if (header->info.build == PLT_BUILD_DEVICE) {
        return plt_build_thesis(o, header);
    }
#endif
    return read_tree(o, header);
}
