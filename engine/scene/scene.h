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
#include "engine/grid/grid.h"
#include "engine/instances/bodies.h"
#include "engine/instances/top.h"
#include "engine/memory/stream.h"
#include "engine/memory/treelet_stream.h"
#include "engine/scene/formats.h"
#include "engine/surface/surface_data.h"
#include "engine/tree/bvh4.h"
#include "engine/tree/compact/block_tree.h"
#include "engine/tree/thesis/tree.h"
#include "engine/tree/vertex_lists.h"

/* All triangles of a scene without a tree. */
typedef struct plt_list {
    const plt_record *records;
    uint32_t count;
} plt_list;

/* All triangles, and cells that refer to them. */
typedef struct plt_gridded {
    const plt_record *records;
    uint32_t count;
    const plt_grid *grid;
} plt_gridded;

#if PLT_WITH_INSTANCES
/* Bodies, and instances of them, which are where the last matrices have placed them. */
typedef struct plt_instanced {
    const plt_node *nodes;
    const plt_record *records;
    plt_bodies bodies;
    uint32_t treelet_nodes;
    const plt_placed *placed; /* by instance */
    const plt_top_node *top;
    uint32_t root; /* a child of the top tree */
    float spread;  /* of plt_placed_margin */
} plt_instanced;
#endif

typedef struct plt_scene {
    plt_info info;
    plt_box box;    /* of all triangles; empty when there are none */
    uint8_t format; /* enum plt_format: the member that holds the tree */
    union {
        plt_tree thesis;
        plt_block_tree compact;
        plt_list list;
        plt_gridded gridded;
#if PLT_WITH_INSTANCES
        plt_instanced instanced;
#endif
    };
    union { /* of a streamed scene: where its parts come from */
        plt_stream_image stream;
        plt_treelet_image treelets;
#if PLT_WITH_VERTICES
        plt_vertex_lists vertices; /* of nodes over triangles without records: those */
#endif
    };
    const plt_bvh4 *bvh4; /* the tree again, as the wave wants it; NULL: not asked for */
#if PLT_WITH_SURFACE
    plt_surface_data surface;
#endif
} plt_scene;

/* Of a resident scene that has them all: its records, in an order of their own; else NULL. */
static inline const plt_record *plt_scene_records(const plt_scene *s) {
    switch (s->format) {
    case PLT_FORMAT_THESIS:
        return s->thesis.records;
    case PLT_FORMAT_LIST:
        return s->list.records;
    case PLT_FORMAT_GRID:
        return s->gridded.records;
    default:
        return NULL;
    }
}

#endif
