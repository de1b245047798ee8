/* open_streamed - scenes whose blocks stay in the source
 *
 * Nothing but the header is read. What opening a resident scene checks of blocks is checked of
 * each when it arrives (memory/stream.c).
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/header_at.h"
#include "engine/scene/compact_tree.h"
#include "engine/scene/open_formats.h"

/* The root is what no block says. */
static int root_is_valid(const plt_block_tree *tree, const plt_info *info) {
    if (tree->root == PLT_LINK_NONE) {
        return info->triangles == 0;
    }
    return plt_block_address(tree->root) == 0 && plt_block_node_bytes(tree->root) <= tree->used;
}

int plt_open_streamed(const plt_opening *o, const plt_header *header,
                      struct plt_compact_build **build) {
    const plt_info *info = &header->info;
    const plt_section *ids = plt_header_section(header, PLT_SECTION_PRIMITIVE_IDS);
    plt_scene *scene = o->scene;
    (void)build;
    plt_compact_describe(&scene->compact, header);
    scene->compact.used = info->node_bytes + info->triangle_bytes;
    scene->stream.source = o->source;
    scene->stream.blocks_at = plt_header_section(header, plt_header_blocks_kind(info))->offset;
#if PLT_WITH_STILLS
    scene->stream.stills_at = scene->stream.blocks_at;
#endif
    scene->stream.ids_at = ids != NULL ? ids->offset : 0;
    scene->stream.triangles = info->triangles;
    scene->stream.source_triangles = info->source_triangles;
    if (!root_is_valid(&scene->compact, info)) {
        return plt_broken(o->fault, PLT_I17_LINKS, PLT_AT_ROOT, "the root link leads astray");
    }
    return info->depth_stack_entries <= PLT_DEPTH_MAX
               ? PLT_OK
               : plt_limit(o->fault, "the tree is deeper than PLT_DEPTH_MAX");
}
