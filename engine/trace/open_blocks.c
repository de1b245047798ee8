/* open_blocks - see open_blocks.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/open_blocks.h"

#include "engine/planelet.h"

void plt_open_blocks_begin(plt_open_block *places) {
    for (unsigned i = 0; i < PLT_OPEN_BLOCKS; i++) {
        places[i].link = PLT_MISS;
    }
}

void plt_open_block_set(plt_open_block *place, const plt_block_tree *tree, uint32_t link) {
    plt_lattice_box frame;
    plt_block_open(&place->block, tree->bytes + plt_block_address(link), tree->lattice.bits);
    plt_block_frame(&place->block, tree->lattice.bits, &frame);
    plt_lattice_spread(&frame, place->lo, place->hi);
    place->link = link;
    place->geometry_open = 0;
}

void plt_open_block_geometry(plt_open_block *o, const plt_block_tree *tree) {
    plt_lattice_box frame;
    if (tree->records != NULL) {
        plt_geometry_open_counts(&o->geometry, &o->block, tree->leaf_triangles);
    } else {
        plt_block_frame(&o->block, tree->lattice.bits, &frame);
        plt_geometry_open(&o->geometry, &o->block, &frame, tree->leaf_triangles);
    }
    o->geometry_open = 1;
}
