/* block_engine_walk - what the engine's own functions make of compact blocks
 *
 * For images that the second decoder has found sound: the engine's functions
 * check nothing. Blocks one behind the other, in a block slots in order.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_BLOCK_ENGINE_WALK_H
#define REFERENCE_BLOCK_ENGINE_WALK_H
#include "engine/tree/compact/block.h"
#include "tests/reference/block_decoder.h"

/* A child of a node: of slot 2 * node + child, counted over all blocks. */
typedef struct engine_child {
    enum plt_slot_kind kind;
    uint32_t rank;  /* among those of its kind in the block */
    uint32_t link;  /* of an edge */
    uint32_t first; /* of a leaf: image order of its first triangle, */
    uint32_t count; /* and how many there are */
    plt_lattice_box box;
    plt_box floats;
} engine_child;

typedef struct engine_block {
    uint32_t address, node_bytes, geometry_bytes, nodes, edges, leaves, pairs;
    uint32_t first_triangle, triangles, vertices, mesh; /* 0 without geometry */
    plt_lattice_box frame;
} engine_block;

/* A triangle with lattice geometry begins with its least corner. */
typedef struct engine_triangle {
    uint32_t corner[3][3]; /* 0 with float records */
    float point[3][3];
    uint32_t number, rotation;
} engine_triangle;

typedef struct engine_walk {
    engine_block *block;
    engine_child *child;
    engine_triangle *triangle;
    uint32_t blocks, children, triangles;
} engine_walk;

/* Memory that is out ends the program. */
void engine_walk_make(engine_walk *walk, const unsigned char *image, const decoded_header *header);
void engine_walk_free(engine_walk *walk);

#endif
