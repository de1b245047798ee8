/* parts - the parts of an arena, one row each
 *
 * The rows below are the only list of what lies in an arena: plt_arena_need adds
 * them up, opening cuts them, `planelet info` prints them and DESIGN.md, section 3,
 * explains them. How many bytes a part takes is in engine/layout.c.
 *
 * Parts of a scene come first and stay. The scratch of validation and of the
 * builder is given back, and what runs then is cut where it was: so an arena must
 * hold the parts that stay and the greatest of the three groups behind them.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_PARTS_H
#define PLT_SCENE_PARTS_H

#include <stddef.h>
#include <stdint.h>

#include "engine/planelet.h"

#if PLT_WITH_TASK
#define PLT_PARTS_OF_WORKERS(ROW)                                                                  \
    ROW(COLOURS, RUNS, "finished packets, colours")                                                \
    ROW(EDGES, RUNS, "edges of a task")
#else
#define PLT_PARTS_OF_WORKERS(ROW)
#endif

#if PLT_WITH_BATCH
#define PLT_PARTS_OF_BATCHES(ROW)                                                                  \
    ROW(BATCH, RUNS, "packets of a batch")                                                         \
    ROW(TASKS, RUNS, "packets that wait at blocks")                                                \
    PLT_PARTS_OF_WORKERS(ROW)
#else
#define PLT_PARTS_OF_BATCHES(ROW)
#endif

#if PLT_WITH_VERTICES
#define PLT_PARTS_OF_VERTICES(ROW) ROW(BESIDE, RUNS, "nodes of the next frame")
#else
#define PLT_PARTS_OF_VERTICES(ROW)
#endif

#if PLT_WITH_SEQUENCE
#define PLT_PARTS_OF_SEQUENCES(ROW)                                                                \
    ROW(TOPOLOGY, RUNS, "vertices of each triangle")                                               \
    ROW(OFFSETS, RUNS, "offsets of frames")                                                        \
    ROW(VERTICES, RUNS, "vertices of a frame")                                                     \
    ROW(WINDOW, RUNS, "window onto frames")                                                        \
    PLT_PARTS_OF_VERTICES(ROW)
#else
#define PLT_PARTS_OF_SEQUENCES(ROW)
#endif

/* The room comes first of what runs: it lies behind the nodes. */
#if PLT_WITH_REBUILD
#define PLT_PARTS_OF_ROOM(ROW) ROW(ROOM, RUNS, "room for more nodes")
#define PLT_PARTS_OF_REBUILDS(ROW) ROW(REBUILD, RUNS, "tree that is rebuilt")
#else
#define PLT_PARTS_OF_ROOM(ROW)
#define PLT_PARTS_OF_REBUILDS(ROW)
#endif

#if PLT_WITH_MOVE_SOME
#define PLT_PARTS_OF_SOME(ROW) ROW(DIRTY, RUNS, "triangles that move")
#else
#define PLT_PARTS_OF_SOME(ROW)
#endif

#if PLT_WITH_BLOCK_MOTION
#define PLT_PARTS_OF_BLOCKS(ROW) ROW(BLOCKS, RUNS, "blocks that move")
#else
#define PLT_PARTS_OF_BLOCKS(ROW)
#endif

#if PLT_WITH_MOTION
#define PLT_PARTS_OF_MOTION(ROW)                                                                   \
    ROW(REFIT, RUNS, "levels of a refit")                                                          \
    PLT_PARTS_OF_BLOCKS(ROW)                                                                       \
    PLT_PARTS_OF_SOME(ROW)                                                                         \
    PLT_PARTS_OF_REBUILDS(ROW)                                                                     \
    PLT_PARTS_OF_SEQUENCES(ROW)
#else
#define PLT_PARTS_OF_MOTION(ROW)
#endif

#if PLT_WITH_GRID
#define PLT_PARTS_OF_GRIDS(ROW) ROW(GRID, RUNS, "grid")
#else
#define PLT_PARTS_OF_GRIDS(ROW)
#endif

#if PLT_WITH_INSTANCES
#define PLT_PARTS_OF_INSTANCES(ROW)                                                                \
    ROW(INNER, RUNS, "packet as a body sees it")                                                   \
    ROW(INSTANCES, RUNS, "instances and their tree")                                               \
    ROW(MATRICES, RUNS, "matrices of a frame")
#else
#define PLT_PARTS_OF_INSTANCES(ROW)
#endif

#if PLT_WITH_PAGES
#define PLT_PARTS_OF_PAGES(ROW) ROW(KEPT, RUNS, "triangles of hits")
#else
#define PLT_PARTS_OF_PAGES(ROW)
#endif

#if PLT_WITH_SURFACE
#define PLT_PARTS_OF_SURFACES(ROW)                                                                 \
    ROW(SURFACE, RUNS, "normals and colours, copied")                                              \
    ROW(PLACES, RUNS, "records of triangles")                                                      \
    PLT_PARTS_OF_PAGES(ROW)
#else
#define PLT_PARTS_OF_SURFACES(ROW)
#endif

#if PLT_WITH_TEXTURE
#define PLT_PARTS_OF_TEXTURES(ROW)                                                                 \
    ROW(TEXTURES, RUNS, "textures")                                                                \
    ROW(TILES, RUNS, "tiles of textures")
#else
#define PLT_PARTS_OF_TEXTURES(ROW)
#endif

#if PLT_WITH_MATERIALS
#define PLT_PARTS_OF_MATERIALS(ROW)                                                                \
    ROW(MATERIALS, RUNS, "materials")                                                              \
    PLT_PARTS_OF_TEXTURES(ROW)
#else
#define PLT_PARTS_OF_MATERIALS(ROW)
#endif

#if PLT_WITH_WHITTED
#define PLT_PARTS_OF_LIGHT(ROW)                                                                    \
    ROW(WHITTED, RUNS, "pixels with lights and mirrors")                                           \
    PLT_PARTS_OF_MATERIALS(ROW)
#else
#define PLT_PARTS_OF_LIGHT(ROW) PLT_PARTS_OF_MATERIALS(ROW)
#endif

/* ROW(name, lifetime, what it is) in the order of the cuts. */
#define PLT_PARTS(ROW)                                                                             \
    ROW(ENGINE, STAYS, "engine")                                                                   \
    ROW(SECTIONS, STAYS, "sections of the image, copied")                                          \
    ROW(TREE, STAYS, "tree, built here")                                                           \
    ROW(VALIDATION, VALIDATES, "validation")                                                       \
    ROW(BUILDER, BUILDS, "builder")                                                                \
    ROW(RECORD_CACHE, BUILDS, "cached corners")                                                    \
    PLT_PARTS_OF_ROOM(ROW)                                                                         \
    ROW(TOUCHED, RUNS, "touched blocks, a bit each")                                               \
    ROW(PACKET, RUNS, "packet of rays")                                                            \
    PLT_PARTS_OF_BATCHES(ROW)                                                                      \
    ROW(TILE_BUFFER, RUNS, "tile buffer")                                                          \
    ROW(STACK, RUNS, "traversal stack")                                                            \
    ROW(LOCAL_STACK, RUNS, "local stack")                                                          \
    ROW(LEAVES, RUNS, "leaves that wait")                                                          \
    ROW(FORMAT, RUNS, "state of the format")                                                       \
    ROW(STORE, RUNS, "streamed blocks")                                                            \
    PLT_PARTS_OF_INSTANCES(ROW)                                                                    \
    PLT_PARTS_OF_SURFACES(ROW)                                                                     \
    PLT_PARTS_OF_MOTION(ROW)                                                                       \
    PLT_PARTS_OF_LIGHT(ROW)                                                                        \
    ROW(WIDE_FORM, RUNS, "wide form of the tree")                                                  \
    ROW(WAVE, RUNS, "rays in flight")                                                              \
    PLT_PARTS_OF_GRIDS(ROW)

enum plt_part {
#define PLT_PART_NAMED(name, lifetime, text) PLT_PART_##name,
    PLT_PARTS(PLT_PART_NAMED)
#undef PLT_PART_NAMED
        PLT_PARTS_COUNT
};

/* Bytes of each part. What a machine cannot address is the largest multiple of PLT_ALIGN that it
 * can: no arena has that much. Sums take 64 bits. */
typedef struct plt_layout {
    size_t bytes[PLT_PARTS_COUNT];
} plt_layout;

static inline enum plt_lifetime plt_part_lifetime(enum plt_part part) {
    static const uint8_t lifetime[PLT_PARTS_COUNT] = {
#define PLT_PART_LIFETIME(name, lifetime, text) PLT_LIFETIME_##lifetime,
        PLT_PARTS(PLT_PART_LIFETIME)
#undef PLT_PART_LIFETIME
    };
    return (enum plt_lifetime)lifetime[part];
}

#endif
