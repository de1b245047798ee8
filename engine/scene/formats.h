/* formats - the one list of what a scene can be
 *
 * A format is a row here, a member of plt_scene (scene.h; streamed scenes have those of
 * resident ones), and files of its own:
 * scene/open_NAME.c opens it, trace/format_NAME.h and trace/traverse_NAME.c traverse it.
 * Declarations and switches over formats are made from this list; engine/layout.c says
 * what each takes of an arena.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_FORMATS_H
#define PLT_SCENE_FORMATS_H

#include "engine/planelet.h"

/* Without them such images are refused by their headers, or have records. */
#if PLT_WITH_INSTANCES
#define PLT_FORMATS_OF_INSTANCES(ROW) ROW(INSTANCES, instances, PLT_WITH_INSTANCES, "instances")
#else
#define PLT_FORMATS_OF_INSTANCES(ROW)
#define PLT_FORMAT_INSTANCES 255 /* no scene's */
#endif

#if PLT_WITH_VERTICES
#define PLT_FORMATS_OF_VERTICES(ROW) ROW(VERTICES, vertices, PLT_WITH_VERTICES, "vertices")
#else
#define PLT_FORMATS_OF_VERTICES(ROW)
#define PLT_FORMAT_VERTICES 254 /* no scene's */
#endif

/* ROW(NAME, name, knob that builds it in, what it is) */
#define PLT_FORMATS(ROW)                                                                           \
    ROW(THESIS, thesis, PLT_WITH_THESIS, "thesis nodes (PLT_WITH_THESIS)")                         \
    ROW(COMPACT, compact, PLT_WITH_COMPACT, "compact blocks (PLT_WITH_COMPACT)")                   \
    ROW(STREAMED, streamed, PLT_WITH_STREAMED_COMPACT,                                             \
        "streamed compact blocks (PLT_WITH_STREAMED_COMPACT)")                                     \
    ROW(STREAMED_THESIS, streamed_thesis, PLT_WITH_STREAMED_THESIS,                                \
        "streamed thesis nodes (PLT_WITH_STREAMED_THESIS)")                                        \
    ROW(LIST, list, PLT_WITH_THESIS, "lists without a tree (PLT_WITH_THESIS)")                     \
    ROW(GRID, grid, PLT_WITH_GRID, "grids (PLT_WITH_GRID)")                                        \
    PLT_FORMATS_OF_VERTICES(ROW)                                                                   \
    PLT_FORMATS_OF_INSTANCES(ROW)

enum plt_format {
#define PLT_FORMAT_NAMED(NAME, name, with, text) PLT_FORMAT_##NAME,
    PLT_FORMATS(PLT_FORMAT_NAMED)
#undef PLT_FORMAT_NAMED
};

/* PLT_IF(knob, text): the text if the knob is 1, nothing if it is 0. Knobs are those
 * digits, and nothing else compiles. */
#define PLT_IF_1(...) __VA_ARGS__
#define PLT_IF_0(...)
#define PLT_IF_JOINED(with, ...) PLT_IF_##with(__VA_ARGS__)
#define PLT_IF(with, ...) PLT_IF_JOINED(with, __VA_ARGS__)

/* Bodies that instances place. */
static inline int plt_has_instances(const plt_info *info) {
    return PLT_WITH_INSTANCES && info->instances > 0;
}

/* A finished tree can be streamed, if anything can: compact blocks with lattice geometry, and
 * thesis nodes in treelets that are not too large. */
static inline int plt_can_stream(const plt_info *info) {
    return PLT_WITH_STREAMED && info->build == PLT_BUILD_HOST && !plt_has_instances(info) &&
           (info->nodes_format == PLT_NODES_COMPACT
                ? info->geometry_format == PLT_GEOMETRY_LATTICE ||
                      (PLT_WITH_STILLS && info->geometry_format == PLT_GEOMETRY_STILLS)
                : info->treelet_nodes <= PLT_STREAMED_TREELET_MOST);
}

/* 0, known when it is compiled, where the engine has no streamed scenes. */
static inline int plt_is_streamed(unsigned format) {
    return PLT_WITH_STREAMED &&
           (format == PLT_FORMAT_STREAMED || format == PLT_FORMAT_STREAMED_THESIS);
}

/* Compact blocks, resident or streamed. */
static inline int plt_has_blocks(unsigned format) {
    return format == PLT_FORMAT_COMPACT || (PLT_WITH_STREAMED && format == PLT_FORMAT_STREAMED);
}

/* Triangles are records while a beam is traced, that pixels share in a store of its own. */
static inline int plt_has_store(unsigned format) {
    return plt_has_blocks(format) || (PLT_WITH_VERTICES && format == PLT_FORMAT_VERTICES);
}

/* Frames of all formats but streamed thesis nodes and instances may go by beams. */
static inline int plt_has_beams(unsigned format) {
    return PLT_WITH_BEAMS && !(PLT_WITH_STREAMED && format == PLT_FORMAT_STREAMED_THESIS) &&
           !(PLT_WITH_INSTANCES && format == PLT_FORMAT_INSTANCES);
}

/* `residency`, `structure`: as in plt_options. */
static inline enum plt_format plt_format_of(const plt_info *info, unsigned residency,
                                            unsigned structure) {
    if (plt_has_instances(info)) {
        return PLT_FORMAT_INSTANCES;
    }
    if (PLT_WITH_GRID && structure == PLT_STRUCTURE_GRID) {
        return PLT_FORMAT_GRID;
    }
    if (info->build == PLT_BUILD_NONE) {
        return PLT_FORMAT_LIST;
    }
    if (residency == PLT_RESIDENCY_STREAMED && plt_can_stream(info)) {
        return info->nodes_format == PLT_NODES_COMPACT ? PLT_FORMAT_STREAMED
                                                       : PLT_FORMAT_STREAMED_THESIS;
    }
    return info->nodes_format == PLT_NODES_COMPACT ? PLT_FORMAT_COMPACT : PLT_FORMAT_THESIS;
}

#endif
