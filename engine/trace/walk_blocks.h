/* walk_blocks - a packet through compact blocks, depth first
 *
 * Boxes are decoded once a packet and visit, in whole lattice numbers. They are
 * kept in floats, which hold whole numbers up to 2^24 exactly, so that the
 * 4-lane operations do all three axes at once; a lattice has at most 21 bits.
 * They become planes of the scene just before they are tested: all that
 * follows is what it is for thesis nodes, and hits are the same bit for bit.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WALK_BLOCKS_H
#define PLT_TRACE_WALK_BLOCKS_H

#include "engine/trace/packet.h"
#include "engine/tree/block_survey.h"

/* What waits: a node of a block, an edge to one, or a unit of triangles. */
typedef struct plt_block_entry {
    float lo[4], hi[4]; /* lattice numbers; the fourth means nothing */
    uint32_t link;      /* of its block; of an edge the block behind it */
    uint8_t kind;       /* enum plt_slot_kind */
    uint8_t number;     /* node or unit */
    uint8_t pairs;      /* unit: pairs before it */
    uint8_t pair;       /* unit: it is one */
    plt_mask groups;
} plt_block_entry;

typedef struct plt_block_walker {
    plt_block_tree tree;
    plt_block_entry *stack;
    float origin[4]; /* of the lattice, as 4-lane operations load it */
    /* the block in hand */
    plt_block block;
    plt_geometry geometry;
    uint32_t link; /* PLT_MISS: none */
    uint8_t geometry_open;
} plt_block_walker;

struct plt_walker;

/* As plt_walk_begin and plt_walk_depth_first (walk.h). */
void plt_walk_blocks_begin(struct plt_walker *w);
uint32_t plt_walk_blocks(struct plt_walker *w, uint32_t visits);

#endif
