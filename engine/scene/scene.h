/* scene - what rays meet: a tree over triangles, in one of the formats
 *
 * Constant once it is opened: any number of traversals, on any number of
 * threads, read one scene. Its bytes lie in the image, when that is mapped, or
 * in the arena.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_SCENE_H
#define PLT_SCENE_SCENE_H

#include "engine/base/box.h"
#include "engine/planelet.h"
#include "engine/tree/compact/block_tree.h"
#include "engine/tree/thesis/tree.h"

/* What a traversal has to know how to read. A new one is a header in trace/
 * and a line in each of the two switches, scene/open.c and trace/traverse.c. */
enum plt_format {
    PLT_FORMAT_THESIS,  /* thesis nodes over float records */
    PLT_FORMAT_COMPACT, /* compact blocks; their leaves are strips or float records */
    PLT_FORMAT_LIST     /* no tree: one list of float records */
};

/* All triangles of a scene without a tree. */
typedef struct plt_list {
    const plt_record *records;
    uint32_t count;
} plt_list;

typedef struct plt_scene {
    plt_info info;
    plt_box box;    /* of all triangles; empty when there are none */
    uint8_t format; /* enum plt_format: the member that holds the tree */
    union {
        plt_tree thesis;
        plt_block_tree compact;
        plt_list list;
    };
} plt_scene;

static inline enum plt_format plt_format_of(const plt_info *info) {
    if (info->build == PLT_BUILD_NONE) {
        return PLT_FORMAT_LIST;
    }
    return info->nodes_format == PLT_NODES_COMPACT ? PLT_FORMAT_COMPACT : PLT_FORMAT_THESIS;
}

#endif
