/* open_streamed_thesis - scenes whose thesis nodes and records stay in the source
 *
 * Nothing but the header is read. What opening a resident scene checks of nodes and records is
 * checked of each when it arrives (memory/treelet_stream.c).
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/header_at.h"
#include "engine/scene/open_formats.h"
#include "engine/tree/thesis/link.h"

/* What no treelet says: the root is the first node, or a leaf the first lists. */
static int root_rule(const plt_header *header) {
    if (header->root == PLT_LINK_NONE) {
        return header->info.triangles > 0 ? PLT_I4_LIST_ORDER : 0;
    }
    if (plt_link_is_leaf(header->root)) {
        return plt_link_index(header->root) != 0 || header->info.triangles == 0 ? PLT_I4_LIST_ORDER
                                                                                : 0;
    }
    return plt_link_index(header->root) != 0 || header->info.node_slots == 0 ? PLT_I1_LINKS : 0;
}

int plt_open_streamed_thesis(const plt_opening *o, const plt_header *header,
                             struct plt_compact_build **build) {
    plt_scene *scene = o->scene;
    const plt_section *checks = plt_header_section(header, PLT_SECTION_CHECKS);
    (void)build;
    scene->thesis.node_slots = header->info.node_slots;
    scene->thesis.records_count = header->info.triangles;
    scene->thesis.treelet_nodes = header->info.treelet_nodes;
    scene->thesis.root = header->root;
    scene->treelets.source = o->source;
    scene->treelets.nodes_at = plt_header_section(header, PLT_SECTION_NODES)->offset;
    scene->treelets.checks_at = checks != NULL ? checks->offset : 0;
    scene->treelets.records_at = plt_header_section(header, PLT_SECTION_TRIANGLES)->offset;
    const int rule = root_rule(header);
    if (rule != 0) {
        return plt_broken(o->fault, (uint8_t)rule, PLT_AT_ROOT, "the root link leads astray");
    }
    if (PLT_DEPTH_MAX > PLT_TREELET_DEPTH_MOST &&
        header->info.treelet_nodes > PLT_TREELET_DEPTH_MOST) {
        return plt_limit(o->fault,
                         "streamed treelets of more than 64 nodes may be deeper than "
                         "64, which this build allows");
    }
    return header->info.depth_stack_entries <= PLT_DEPTH_MAX
               ? PLT_OK
               : plt_limit(o->fault, "the tree is deeper than PLT_DEPTH_MAX");
}
