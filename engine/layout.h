/* layout - how many bytes each part of an arena takes
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_LAYOUT_H
#define PLT_LAYOUT_H

#include "engine/scene/formats.h"
#include "engine/scene/parts.h"

/* The options are in range, and this build can open such an image with them. */
int plt_layout_options_valid(const plt_options *options);
int plt_layout_order_valid(const plt_info *info, const plt_options *options);

/* Triangles can be moved that are records, in thesis nodes or a list; and those of compact blocks
 * that have frames, all of them: as differences, or streamed as stills. */
static inline int plt_layout_motion_valid(const plt_info *info, const plt_options *options) {
    const int is_streamed = PLT_WITH_STREAMED && options->residency == PLT_RESIDENCY_STREAMED;
    if (!PLT_WITH_MOTION || !options->movable) {
        return 1;
    }
    if (!PLT_WITH_COMPACT || info->nodes_format == PLT_NODES_THESIS) {
        return !is_streamed && !plt_has_instances(info);
    }
    return PLT_WITH_BLOCK_MOTION && !options->moves_some && !options->rebuild &&
           info->geometry_format == (is_streamed ? PLT_GEOMETRY_STILLS : PLT_GEOMETRY_MOVING);
}

#if PLT_WITH_VERTICES
/* Records may be left out. */
static inline int plt_layout_records_optional(const plt_info *info, const plt_options *options) {
    return options->movable && info->frames > 0 && info->nodes_format == PLT_NODES_THESIS &&
           info->build == PLT_BUILD_HOST && !options->moves_some && !options->rebuild &&
           (!PLT_WITH_GRID || options->structure == PLT_STRUCTURE_TREE);
}
#endif

/* They are: as is said, or with `beside` chosen. */
static inline int plt_layout_over_vertices(const plt_info *info, const plt_options *options) {
#if PLT_WITH_VERTICES
    return plt_layout_records_optional(info, options) &&
           (options->records == PLT_RECORDS_NEVER ||
            (options->records == PLT_RECORDS_AUTO && options->beside));
#else
    (void)info;
    (void)options;
    return 0;
#endif
}

/* What is asked for can be had. */
static inline int plt_layout_records_valid(const plt_info *info, const plt_options *options) {
#if PLT_WITH_VERTICES
    return (options->records != PLT_RECORDS_NEVER && !options->beside) ||
           plt_layout_records_optional(info, options);
#else
    (void)info;
    (void)options;
    return 1;
#endif
}

/* A grid is over records, of thesis nodes or a list. */
static inline int plt_layout_structure_valid(const plt_info *info, const plt_options *options) {
    return !PLT_WITH_GRID || options->structure == PLT_STRUCTURE_TREE ||
           (info->nodes_format == PLT_NODES_THESIS && !plt_has_instances(info));
}

#if PLT_WITH_PAGES
/* The image has tables of normals and colours, which are resident alone. */
static inline int plt_layout_has_tables(const plt_info *info) {
    return info->normal_bytes + info->colour_bytes > 0;
}

/* What is asked for comes page by page, or what is there is, which names triangles in the order of
 * the image. */
static inline int plt_layout_pages_valid(const plt_info *info, const plt_options *options) {
    const int has_pages = info->page_bytes > 0;
    return options->residency == PLT_RESIDENCY_STREAMED
               ? options->schedule == PLT_SCHEDULE_BRANCH &&
                     (has_pages || !plt_layout_has_tables(info))
               : !has_pages || plt_layout_has_tables(info) ||
                     (info->build != PLT_BUILD_DEVICE &&
                      !(PLT_WITH_GRID && options->structure == PLT_STRUCTURE_GRID));
}
#else
static inline int plt_layout_pages_valid(const plt_info *info, const plt_options *options) {
    (void)info;
    return !(PLT_WITH_STREAMED && options->residency == PLT_RESIDENCY_STREAMED);
}
#endif

/* Normals and colours are of triangles that stay where they are. */
static inline int plt_layout_surface_valid(const plt_info *info, const plt_options *options) {
#if PLT_WITH_SURFACE
    return !options->surface ||
           ((info->nodes_format == PLT_NODES_THESIS ||
             (info->build == PLT_BUILD_HOST && info->geometry_format <= PLT_GEOMETRY_LATTICE)) &&
            !plt_has_instances(info) && !(PLT_WITH_MOTION && options->movable) &&
            plt_layout_pages_valid(info, options));
#else
    (void)info;
    (void)options;
    return 1;
#endif
}

/* There is to be room for a second tree. */
static inline int plt_layout_rebuilds(const plt_info *info, const plt_options *options) {
    return PLT_WITH_REBUILD && options->movable && options->rebuild &&
           info->build != PLT_BUILD_NONE &&
           (!PLT_WITH_GRID || options->structure == PLT_STRUCTURE_TREE);
}

#if PLT_WITH_REBUILD
/* Slots for nodes of a tree that is rebuilt: of the largest there can be, or if it is subtrees that
 * are rebuilt as many as there are. */
uint32_t plt_layout_rebuild_room(const plt_info *info, const plt_options *options);
#endif

#if PLT_WITH_SUBTREES
/* Bytes of scratch beside `room` nodes of a subtree. */
uint64_t plt_layout_part_scratch(uint32_t room);
#endif

/* Where the engine has no streamed scenes, options ask for none. */
static inline int plt_layout_residency_valid(const plt_info *info, const plt_options *options) {
    return !PLT_WITH_STREAMED || options->residency != PLT_RESIDENCY_STREAMED ||
           plt_can_stream(info);
}

/* Fills in every part. `info`: what the image says; `sized_for`: counts of the tree that
 * will be traversed: the image's, the worst that may be built (plt_worst_tree), or those of
 * the one that was built. */
void plt_layout_set(plt_layout *layout, const plt_info *info, const plt_info *sized_for, int mapped,
                    const plt_options *options);

/* The same for an image that is not open yet. */
void plt_layout_of_image(plt_layout *layout, const plt_info *info, int mapped,
                         const plt_options *options);

/* Bytes of what runs, which is cut last. */
uint64_t plt_layout_running(const plt_layout *layout);

/* What an arena must hold for these parts. */
uint64_t plt_layout_need(const plt_layout *layout);

#endif
